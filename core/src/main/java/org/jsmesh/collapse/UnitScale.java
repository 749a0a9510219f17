package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;

/** The vertices of a mesh under simplification, scaled to a bounding box with a diagonal of 1, and the areas about them. */
final class UnitScale {
    private final CollapseMesh mesh;
    private final double[] positions;

    UnitScale(CollapseMesh mesh) {
        this.mesh = mesh;
        int vertices = mesh.table().vertices();
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int v = 0; v < vertices; v++) {
            if (mesh.table().cornerOf(v) < 0) continue; // not referenced
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], mesh.position(v, axis));
                high[axis] = Math.max(high[axis], mesh.position(v, axis));
            }
        }
        double dx = high[0] - low[0];
        double dy = high[1] - low[1];
        double dz = high[2] - low[2];
        double diagonal = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double scale = diagonal > 0 ? 1 / diagonal : 1;
        positions = new double[3 * vertices];
        for (int v = 0; v < vertices; v++) {
            for (int axis = 0; axis < 3; axis++) positions[3 * v + axis] = (mesh.position(v, axis) - low[axis]) * scale;
        }
    }

    /** x, y, z of each fan vertex. */
    double[] positions() {
        return positions;
    }

    /** Sum of the areas of the faces about each fan vertex. */
    double[] vertexAreas() {
        CornerTable t = mesh.table();
        double[] areas = new double[t.vertices()];
        Mesh original = mesh.original();
        for (int f = 0; f < original.faces(); f++) {
            if (!mesh.isLiveFace(f)) continue;
            int a = t.vertex(CornerTable.STRIDE * f);
            int b = t.vertex(CornerTable.STRIDE * f + 1);
            int c = t.vertex(CornerTable.STRIDE * f + 2);
            double area = area(3 * a, 3 * b, 3 * c);
            areas[a] += area;
            areas[b] += area;
            areas[c] += area;
        }
        return areas;
    }

    private double area(int a, int b, int c) {
        double[] p = positions;
        double ax = p[b] - p[a];
        double ay = p[b + 1] - p[a + 1];
        double az = p[b + 2] - p[a + 2];
        double bx = p[c] - p[a];
        double by = p[c + 1] - p[a + 1];
        double bz = p[c + 2] - p[a + 2];
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        return 0.5 * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
}
