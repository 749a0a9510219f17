package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;

/**
 * The vertices of a mesh under simplification, the factor that scales its bounding box to a diagonal of 1, and areas in
 * that scale.
 */
final class UnitScale {
    private final CollapseMesh mesh;
    private final float[] positions;
    private final double factor;

    UnitScale(CollapseMesh mesh) {
        this.mesh = mesh;
        positions = mesh.fanPositions();
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int v = 0; v < mesh.table().vertices(); v++) {
            if (mesh.table().cornerOf(v) < 0) continue; // not referenced
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], positions[3 * v + axis]);
                high[axis] = Math.max(high[axis], positions[3 * v + axis]);
            }
        }
        double dx = high[0] - low[0];
        double dy = high[1] - low[1];
        double dz = high[2] - low[2];
        double diagonal = Math.sqrt(dx * dx + dy * dy + dz * dz);
        factor = diagonal > 0 ? 1 / diagonal : 1;
    }

    /** x, y, z of each fan vertex, as they are; not to be changed. */
    float[] positions() {
        return positions;
    }

    /** A length of 1 in the unit scale, in parts of one of the mesh. */
    double factor() {
        return factor;
    }

    /** Sum of the areas of the faces about each fan vertex. */
    float[] vertexAreas() {
        CornerTable t = mesh.table();
        float[] areas = new float[t.vertices()];
        Mesh original = mesh.original();
        for (int f = 0; f < original.faces(); f++) {
            if (!mesh.isLiveFace(f)) continue;
            int a = t.vertex(CornerTable.STRIDE * f);
            int b = t.vertex(CornerTable.STRIDE * f + 1);
            int c = t.vertex(CornerTable.STRIDE * f + 2);
            float area = (float) area(3 * a, 3 * b, 3 * c);
            areas[a] += area;
            areas[b] += area;
            areas[c] += area;
        }
        return areas;
    }

    /** Area, in the unit scale, of the triangle whose corners have their coordinates at a, b and c. */
    double area(int a, int b, int c) {
        float[] p = positions;
        double ax = factor * ((double) p[b] - p[a]);
        double ay = factor * ((double) p[b + 1] - p[a + 1]);
        double az = factor * ((double) p[b + 2] - p[a + 2]);
        double bx = factor * ((double) p[c] - p[a]);
        double by = factor * ((double) p[c + 1] - p[a + 1]);
        double bz = factor * ((double) p[c + 2] - p[a + 2]);
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        return 0.5 * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
}
