package org.jsmesh.archive;

import org.jsmesh.codec.CodedMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** What is left of a simplified mesh, with exact positions and no attributes: to measure. */
final class BaseMesh {
    private BaseMesh() {}

    static Mesh of(CodedMesh source) {
        CornerTable t = source.table();
        int faces = 0;
        for (int f = 0; f < t.faces(); f++) if (source.isLiveFace(f)) faces++;
        int[] corners = new int[3 * faces];
        int at = 0;
        for (int f = 0; f < t.faces(); f++) {
            if (!source.isLiveFace(f)) continue;
            for (int j = 0; j < 3; j++) corners[at++] = source.vertexOf()[t.vertex(CornerTable.STRIDE * f + j)];
        }
        return new MeshBuilder()
                .positions(source.original().positions())
                .faceWedges(corners)
                .build();
    }
}
