package org.jsmesh.encode;

import org.jsmesh.codec.CodedMesh;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/** What the codec asks of a mesh that collapses have simplified. */
record SimplifiedMesh(CollapseMesh mesh) implements CodedMesh {
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
    public PatchLog log() {
        return mesh.log();
    }
}
