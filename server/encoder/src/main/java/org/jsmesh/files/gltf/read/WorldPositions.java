package org.jsmesh.files.gltf.read;

import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/**
 * Rounds the positions of vertices in world space once. They become float32, unless a node has moved the mesh so far
 * that float32 would change its shape; then they become the sums of an origin and float32 offsets.
 */
final class WorldPositions {
    /** Errors below this part of the diagonal are no change of the shape. */
    private static final double LARGEST_ERROR = 1e-6;

    private WorldPositions() {}

    static double[] rounded(double[] exact) {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        double error = 0;
        double[] rounded = new double[exact.length];
        for (int i = 0; i < exact.length; i++) {
            low[i % 3] = Math.min(low[i % 3], exact[i]);
            high[i % 3] = Math.max(high[i % 3], exact[i]);
            rounded[i] = (float) exact[i];
            error = Math.max(error, Math.abs(rounded[i] - exact[i]));
        }
        double squares = 0;
        for (int a = 0; a < 3; a++) squares += (high[a] - low[a]) * (high[a] - low[a]);
        if (exact.length == 0 || error <= LARGEST_ERROR * Math.sqrt(squares)) return rounded;
        Mesh points = new MeshBuilder().positions(exact).build();
        for (int i = 0; i < rounded.length; i++) rounded[i] = points.origin()[i % 3] + points.positions()[i];
        return rounded;
    }
}
