package org.jsmesh.encode;

import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.mesh.Mesh;

/** Meshes as the codec takes them. */
public final class CodedMeshes {
    private CodedMeshes() {}

    /** A mesh that nothing was collapsed in: its archive has a base alone. */
    public static CodedMesh whole(Mesh mesh) {
        return new SimplifiedMesh(new CollapseMesh(mesh));
    }
}
