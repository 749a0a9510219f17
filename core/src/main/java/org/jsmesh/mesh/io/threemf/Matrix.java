package org.jsmesh.mesh.io.threemf;

/**
 * Transforms as 3MF writes them: the upper three columns of a matrix of four rows, row by row, and rows of coordinates
 * are multiplied by it.
 */
final class Matrix {
    private Matrix() {}

    /** First {@code inner}, then {@code outer}; null stands for the one that changes nothing. */
    static double[] product(double[] inner, double[] outer) {
        if (inner == null || outer == null) return inner == null ? outer : inner;
        double[] product = new double[12];
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 3; column++) {
                double sum = row == 3 ? outer[9 + column] : 0;
                for (int k = 0; k < 3; k++) sum += inner[3 * row + k] * outer[3 * k + column];
                product[3 * row + column] = sum;
            }
        }
        return product;
    }

    static double apply(double[] matrix, int axis, double x, double y, double z) {
        return x * matrix[axis] + y * matrix[3 + axis] + z * matrix[6 + axis] + matrix[9 + axis];
    }

    /** Whether it turns surfaces inside out. */
    static boolean isMirror(double[] m) {
        return m[0] * (m[4] * m[8] - m[5] * m[7])
                        - m[1] * (m[3] * m[8] - m[5] * m[6])
                        + m[2] * (m[3] * m[7] - m[4] * m[6])
                < 0;
    }
}
