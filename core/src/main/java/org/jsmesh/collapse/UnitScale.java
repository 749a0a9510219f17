package org.jsmesh.collapse;

import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;

/**
 * The vertices of a mesh under simplification, the factor that scales its bounding box to a diagonal of 1, and areas in
 * that scale.
 */
final class UnitScale {
    private final CollapseMesh mesh;
    private final double factor;
    private float[] positions; // null until they are asked for

    UnitScale(CollapseMesh mesh) {
        this.mesh = mesh;
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (int v = 0; v < mesh.table().vertices(); v++) {
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
        factor = diagonal > 0 ? 1 / diagonal : 1;
    }

    /** x, y, z of each fan vertex, as they are; not to be changed. */
    float[] positions() {
        if (positions == null) positions = mesh.fanPositions();
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
            float area = (float) area(a, b, c);
            areas[a] += area;
            areas[b] += area;
            areas[c] += area;
        }
        return areas;
    }

    /** Area, in the unit scale, of the triangle between three fan vertices. */
    double area(int a, int b, int c) {
        double ax = edge(a, b, 0);
        double ay = edge(a, b, 1);
        double az = edge(a, b, 2);
        double bx = edge(a, c, 0);
        double by = edge(a, c, 1);
        double bz = edge(a, c, 2);
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        return 0.5 * Math.sqrt(nx * nx + ny * ny + nz * nz);
    }

    private double edge(int from, int to, int axis) {
        return factor * ((double) mesh.position(to, axis) - mesh.position(from, axis));
    }
}
