package org.jsmesh.test.picture;

/** Arithmetic of vectors with three components. */
final class Vectors {
    private Vectors() {}

    static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** The vector at length 1; itself when it has none. */
    static double[] unit(double[] a) {
        double length = Math.sqrt(dot(a, a));
        return length == 0 ? a : new double[] {a[0] / length, a[1] / length, a[2] / length};
    }
}
