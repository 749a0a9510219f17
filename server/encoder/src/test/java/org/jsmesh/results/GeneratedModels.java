package org.jsmesh.results;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Bare meshes that no file holds, the same on every JVM. */
final class GeneratedModels {
    private static final int AROUND = 120;
    private static final int ACROSS = 50;
    private static final int SIDE = 78;
    private static final double DECIMALS = 1e5;

    private GeneratedModels() {}

    static Map<String, Mesh> all() {
        Map<String, Mesh> all = new LinkedHashMap<>();
        all.put("generated: wavy torus in decimals", torus());
        all.put("generated: rough terrain with a border", terrain());
        all.put("generated: folded box, flat parts and noise", foldedBox());
        return all;
    }

    /** Vertices are off their grid, as scans have them, and smooth. */
    private static Mesh torus() {
        float[] points = new float[3 * AROUND * ACROSS];
        Random random = new Random(1);
        for (int v = 0; v < AROUND * ACROSS; v++) {
            double phi = 2 * Math.PI * (v % AROUND + .3 * random.nextDouble()) / AROUND;
            double theta = 2 * Math.PI * (v / AROUND + .3 * random.nextDouble()) / ACROSS;
            double tube = 1 + .15 * StrictMath.sin(7 * phi) * StrictMath.cos(5 * theta) + .001 * random.nextGaussian();
            double r = 2.5 + tube * StrictMath.cos(theta);
            points[3 * v] = decimal(r * StrictMath.cos(phi));
            points[3 * v + 1] = decimal(r * StrictMath.sin(phi));
            points[3 * v + 2] = decimal(tube * StrictMath.sin(theta));
        }
        return grid(points, AROUND, ACROSS, true);
    }

    /** Full float32, with detail at every scale. */
    private static Mesh terrain() {
        float[] points = new float[3 * SIDE * SIDE];
        Random random = new Random(2);
        double[] phases = random.doubles(24, 0, 2 * Math.PI).toArray();
        for (int v = 0; v < SIDE * SIDE; v++) {
            double x = (v % SIDE + .4 * random.nextDouble()) / SIDE;
            double y = (v / SIDE + .4 * random.nextDouble()) / SIDE;
            double height = 0;
            for (int i = 0; i < phases.length; i++) {
                double angle = 2.4 * i;
                double along = StrictMath.cos(angle) * x + StrictMath.sin(angle) * y;
                height += StrictMath.sin((i + 2) * (i + 2) * along / 3 + phases[i]) / ((i + 2) * (i + 2));
            }
            points[3 * v] = (float) x;
            points[3 * v + 1] = (float) y;
            points[3 * v + 2] = (float) (.3 * height);
        }
        return grid(points, SIDE, SIDE, false);
    }

    /** A sheet in pleats: sharp edges between planes, of which some are rough. */
    private static Mesh foldedBox() {
        float[] points = new float[3 * SIDE * SIDE];
        Random random = new Random(3);
        for (int v = 0; v < SIDE * SIDE; v++) {
            int column = v % SIDE;
            int row = v / SIDE;
            double fold = Math.abs(column % 26 - 13) / 13.0;
            double noise = column / 26 % 2 == 0 ? 0 : .002 * random.nextGaussian();
            points[3 * v] = decimal(column * .01);
            points[3 * v + 1] = decimal(row * .01 + .0001 * random.nextInt(20));
            points[3 * v + 2] = decimal(.12 * fold + .05 * Math.min(1, Math.abs(row - 39) / 20.0) + noise);
        }
        return grid(points, SIDE, SIDE, false);
    }

    private static Mesh grid(float[] points, int columns, int rows, boolean isClosed) {
        int width = isClosed ? columns : columns - 1;
        int height = isClosed ? rows : rows - 1;
        int[] corners = new int[6 * width * height];
        for (int i = 0; i < width * height; i++) {
            int x = i % width;
            int y = i / width;
            int right = (x + 1) % columns;
            int low = y * columns;
            int high = (y + 1) % rows * columns;
            int[] quad = {low + x, low + right, high + right, low + x, high + right, high + x};
            System.arraycopy(quad, 0, corners, 6 * i, 6);
        }
        return new MeshBuilder().positions(points).faceWedges(corners).build();
    }

    private static float decimal(double x) {
        return (float) (Math.rint(x * DECIMALS) / DECIMALS);
    }
}
