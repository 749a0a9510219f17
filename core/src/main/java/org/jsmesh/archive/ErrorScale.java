package org.jsmesh.archive;

/** Mean errors on a logarithmic scale: 128% · 2^(−step/16), and 0 for the last step. Computed with products alone, the same everywhere. */
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
}
