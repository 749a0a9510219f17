package org.jsmesh.archive.coding;

/**
 * Errors on a logarithmic scale: 128% · 2^(−step/16), and 0 for the last step. Computed with products alone, the same
 * everywhere.
 */
final class ErrorScale {
    static final int ZERO = 1023;
    private static final double[] VALUES = new double[ZERO + 1];

    static {
        double root = Math.sqrt(Math.sqrt(Math.sqrt(Math.sqrt(2.0))));
        VALUES[0] = 128;
        for (int i = 1; i < ZERO; i++) VALUES[i] = i % 16 == 0 ? VALUES[i - 16] / 2 : VALUES[i - 1] / root;
    }

    private ErrorScale() {}

    static double value(int step) {
        return VALUES[step];
    }

    /** The step with the smallest error that is not below the given one. */
    static int step(double error) {
        if (error <= 0) return ZERO;
        int low = 0;
        int high = ZERO - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (VALUES[middle] >= error) low = middle;
            else high = middle - 1;
        }
        return low;
    }

    /** The step whose error is closest to the given one by ratio. Only an error of 0 has the step of 0. */
    static int closest(double error) {
        int step = step(error);
        if (step >= ZERO - 1) return step;
        return error * error < VALUES[step] * VALUES[step + 1] ? step + 1 : step;
    }
}
