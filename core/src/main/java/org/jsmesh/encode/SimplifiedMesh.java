package org.jsmesh.encode;

import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/**
 * Gives the codec a mesh that collapses have simplified.
 *
 * @param isForOnce whether the mesh is released while it is coded
 */
record SimplifiedMesh(CollapseMesh mesh, boolean isForOnce) implements CodedMesh {
    SimplifiedMesh(CollapseMesh mesh) {
        this(mesh, false);
    }

    @Override
    public void isCodedFrom(int patch) {
        if (!isForOnce) return;
        mesh.release();
        mesh.log().forget(patch);
    }

    @Override
    public Mesh original() {
        return mesh.original();
    }

    @Override
    public CornerTable table() {
        return mesh.table();
    }

    @Override
    public int[] vertexOf() {
        return mesh.vertexOf();
    }

    @Override
    public boolean isLiveFace(int face) {
        return mesh.isLiveFace(face);
    }

    @Override
    public int wedge(int corner) {
        return mesh.wedge(corner);
    }

    @Override
    public boolean isSeparate() {
        return mesh.isSeparate();
    }

    @Override
    public int fan(int face, int j) {
        return mesh.fan(face, j);
    }

    @Override
    public PatchLog log() {
        return mesh.log();
    }
}
