package org.jsmesh.encode.write;

import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.mesh.CornerTable;

/** The surface that is left of a simplified mesh, with exact positions, to be measured. */
final class BaseSurface {
    private BaseSurface() {}

    static LodSurface of(CodedMesh source) {
        CornerTable t = source.table();
        int faces = 0;
        for (int f = 0; f < t.faces(); f++) if (source.isLiveFace(f)) faces++;
        int[] corners = new int[3 * faces];
        int at = 0;
        for (int f = 0; f < t.faces(); f++) {
            if (!source.isLiveFace(f)) continue;
            for (int j = 0; j < 3; j++) corners[at++] = source.vertexOf()[t.vertex(CornerTable.STRIDE * f + j)];
        }
        return new LodSurface(source.original().positions(), corners);
    }
}
