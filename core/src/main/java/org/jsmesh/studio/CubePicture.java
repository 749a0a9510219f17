package org.jsmesh.studio;

import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;

/**
 * A function of directions on the six sides of a cube, as three.js 0.181 keeps it on the graphics card. The outermost
 * pixels of a side lie beyond its edges, so that a place on a side has four pixels around it.
 */
final class CubePicture {
    private final int size;
    private final float[] values;

    private CubePicture(int size, ToDoubleFunction<double[]> function, double first, double step) {
        this.size = size;
        values = new float[6 * size * size];
        IntStream.range(0, values.length).parallel().forEach(i -> {
            int side = i / (size * size);
            double[] direction = new double[3];
            direction[side % 3] = side < 3 ? 1 : -1;
            direction[(side + 1) % 3] = first + i % size * step;
            direction[(side + 2) % 3] = first + i / size % size * step;
            double square = 0;
            for (double d : direction) square += d * d;
            double length = Math.sqrt(square);
            for (int k = 0; k < 3; k++) direction[k] /= length;
            values[i] = (float) function.applyAsDouble(direction);
        });
    }

    /**
     * Takes a function in the middle of each pixel, on several threads. A function of a class whose initializer calls
     * this would wait for ever.
     *
     * @param size pixels a side
     */
    static CubePicture of(int size, ToDoubleFunction<double[]> function) {
        return new CubePicture(size, function, -1 - 1. / (size - 2), 2. / (size - 2));
    }

    /**
     * The same for a scene that a camera in the middle of the cube draws. A small lamp is as large as the pixels whose
     * middle it covers. No pixel lies beyond the edges, but the picture is read as if they did: it is a little too
     * large.
     */
    static CubePicture drawn(int size, ToDoubleFunction<double[]> scene) {
        return new CubePicture(size, scene, -1 + 1. / size, 2. / size);
    }

    /** The value in a direction of any length. */
    double at(double[] direction) {
        return at(direction[0], direction[1], direction[2]);
    }

    /** The same, from the four pixels around the direction. */
    double at(double x, double y, double z) {
        double wide = Math.abs(x);
        double high = Math.abs(y);
        double deep = Math.abs(z);
        if (wide >= high && wide >= deep) return at(x > 0 ? 0 : 3, y / wide, z / wide);
        if (high >= deep) return at(y > 0 ? 1 : 4, z / high, x / high);
        return at(z > 0 ? 2 : 5, x / deep, y / deep);
    }

    private double at(int side, double across, double along) {
        double x = (across + 1) / 2 * (size - 2) + .5;
        double y = (along + 1) / 2 * (size - 2) + .5;
        int column = (int) x;
        int row = (int) y;
        double right = x - column;
        double below = y - row;
        int at = (side * size + row) * size + column;
        return (1 - below) * ((1 - right) * values[at] + right * values[at + 1])
                + below * ((1 - right) * values[at + size] + right * values[at + size + 1]);
    }
}
