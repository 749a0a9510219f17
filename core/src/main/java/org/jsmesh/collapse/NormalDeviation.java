package org.jsmesh.collapse;

/**
 * Measures how much the surface bends at a vertex: mean of 1 − cos over the angles between the normals of adjacent
 * faces (section 4.2 of Chen and Nishita 2002). Not thread-safe.
 */
final class NormalDeviation {
    private final VertexStar star;

    NormalDeviation(CollapseMesh mesh, UnitScale scale) {
        star = new VertexStar(mesh, scale);
    }

    /** 0 (flat) to 2; infinite for a vertex that cannot be removed because it has too many faces. */
    double of(int vertex) {
        if (!star.load(vertex)) return Double.POSITIVE_INFINITY;
        star.measure(vertex);
        double[] n = star.normal;
        double sum = 0;
        int before = star.size - 1;
        for (int i = 0; i < star.size; i++) {
            double lengths = star.normalLength[before] * star.normalLength[i];
            int a = 3 * before;
            int b = 3 * i;
            if (lengths > 0) sum += 1 - (n[a] * n[b] + n[a + 1] * n[b + 1] + n[a + 2] * n[b + 2]) / lengths;
            before = i;
        }
        return sum / star.size;
    }
}
