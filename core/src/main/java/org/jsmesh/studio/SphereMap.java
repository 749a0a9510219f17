package org.jsmesh.studio;

import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * A function of directions on a square: the sphere is projected onto an octahedron, whose lower half is folded outwards
 * (Engelhardt and Dachsbacher 2008). A direction (x, y, z) with |x| + |y| + |z| = 1 and y ≥ 0 lies at (x, z) of [−1,
 * 1]².
 *
 * @param size pixels a side
 * @param values row by row
 */
record SphereMap(int size, float[] values) {
    /**
     * Takes a function in the middle of each pixel, on several threads. A function of a class whose initializer calls
     * this would wait for ever.
     */
    static SphereMap of(int size, ToDoubleFunction<double[]> function) {
        float[] values = new float[size * size];
        IntStream.range(0, values.length).parallel().forEach(i -> {
            int row = i / size;
            double[] direction = direction((i % size + .5) / size, (row + .5) / size);
            values[i] = (float) function.applyAsDouble(direction);
        });
        return new SphereMap(size, values);
    }

    /** The direction, of length 1, of a place in [0, 1]². */
    static double[] direction(double across, double along) {
        double x = 2 * across - 1;
        double z = 2 * along - 1;
        double y = 1 - Math.abs(x) - Math.abs(z);
        double[] d = {x, y, z};
        if (y < 0) {
            d[0] = (1 - Math.abs(z)) * (x < 0 ? -1 : 1);
            d[2] = (1 - Math.abs(x)) * (z < 0 ? -1 : 1);
        }
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (int k = 0; k < 3; k++) d[k] /= length;
        return d;
    }

    /** The value in a direction of any length. */
    double at(double[] direction) {
        return at(direction[0], direction[1], direction[2]);
    }

    /** The same, from the four pixels around the direction. */
    double at(double x, double y, double z) {
        double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double a = x / sum;
        double b = z / sum;
        if (y < 0) {
            double folded = (1 - Math.abs(b)) * (a < 0 ? -1 : 1);
            b = (1 - Math.abs(a)) * (b < 0 ? -1 : 1);
            a = folded;
        }
        double across = (a + 1) / 2 * size - .5;
        double along = (b + 1) / 2 * size - .5;
        int column = (int) Math.floor(across);
        int row = (int) Math.floor(along);
        double right = across - column;
        double below = along - row;
        return (1 - below) * ((1 - right) * pixel(column, row) + right * pixel(column + 1, row))
                + below * ((1 - right) * pixel(column, row + 1) + right * pixel(column + 1, row + 1));
    }

    /** A pixel, also one beyond the edge by less than the size: there the map goes on mirrored along that edge. */
    float pixel(int column, int row) {
        int c = column;
        int r = row;
        if (c < 0 || c >= size) {
            c = c < 0 ? -1 - c : 2 * size - 1 - c;
            r = size - 1 - r;
        }
        if (r < 0 || r >= size) {
            r = r < 0 ? -1 - r : 2 * size - 1 - r;
            c = size - 1 - c;
        }
        return values[r * size + c];
    }
}
