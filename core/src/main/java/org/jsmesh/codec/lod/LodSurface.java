package org.jsmesh.codec.lod;

import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.mesh.CornerTable;

/**
 * Positions and faces of a level of detail, to be measured. Attributes are left out, and a coarse position may differ
 * from the shown one by rounding.
 *
 * @param positions x, y, z per vertex; there may be more vertices than faces use
 * @param triangles three vertices per face, real faces only
 */
public record LodSurface(float[] positions, int[] triangles) {
    /** The present positions of a surface's vertices. */
    public interface Places {
        double coordinate(int vertex, int axis);
    }

    public int faces() {
        return triangles.length / 3;
    }

    /** The surface as it is shown. Vertices from {@code coarse} on are known by their cells alone. */
    public static LodSurface shown(LodMesh mesh, double cellSize, Translation translation, int coarse) {
        float[] positions = new float[3 * mesh.vertices()];
        int[] bits = mesh.positionBits();
        for (int i = 0; i < 3 * coarse; i++) positions[i] = Float.intBitsToFloat(translation.moved(i % 3, bits[i]));
        int[] cells = mesh.places();
        for (int v = coarse; v < mesh.vertices(); v++) {
            int at = 4 * mesh.firstFan(v);
            for (int a = 0; a < 3; a++)
                positions[3 * v + a] = (float) (cellSize * cells[at + a] + translation.offset(a));
        }
        int[] triangles = corners(mesh);
        for (int i = 0; i < triangles.length; i++) triangles[i] = mesh.vertexOf(triangles[i]);
        return new LodSurface(positions, triangles);
    }

    /** Fan vertices of the faces that are no dummies, three per face, in the order of the faces. */
    public static int[] corners(LodMesh mesh) {
        int[] corners = new int[3 * mesh.realFaces()];
        if (mesh.isSeparate()) {
            for (int i = 0; i < corners.length; i++) corners[i] = i;
            return corners;
        }
        CornerTable table = mesh.table();
        int n = 0;
        for (int f = 0; f < table.faces(); f++) {
            if (table.isDummy(f)) continue;
            for (int j = 0; j < 3; j++) corners[n++] = table.vertex(CornerTable.STRIDE * f + j);
        }
        return corners;
    }
}
