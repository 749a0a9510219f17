package org.jsmesh.samples;

/** Small functions that fields and paintings are mixed with. */
final class Blend {
    private Blend() {}

    /** The union of two distances with a fillet of about this radius. */
    static double union(double a, double b, double radius) {
        double h = StrictMath.max(radius - StrictMath.abs(a - b), 0) / radius;
        return StrictMath.min(a, b) - 0.25 * h * h * radius;
    }

    /** From 0 at {@code from} to 1 at {@code to}, flat at both ends. */
    static double ramp(double from, double to, double x) {
        double t = StrictMath.max(0, StrictMath.min(1, (x - from) / (to - from)));
        return t * t * (3 - 2 * t);
    }

    static double mix(double a, double b, double t) {
        return a + (b - a) * t;
    }

    /** Smooth noise from −1 to 1, about one bump per unit. */
    static double noise(double x, double y, double z) {
        double fx = StrictMath.floor(x);
        double fy = StrictMath.floor(y);
        double fz = StrictMath.floor(z);
        double tx = ramp(0, 1, x - fx);
        double ty = ramp(0, 1, y - fy);
        double tz = ramp(0, 1, z - fz);
        double sum = 0;
        for (int corner = 0; corner < 8; corner++) {
            int i = corner & 1;
            int j = corner >> 1 & 1;
            int k = corner >> 2;
            double weight = (i == 0 ? 1 - tx : tx) * (j == 0 ? 1 - ty : ty) * (k == 0 ? 1 - tz : tz);
            sum += weight * hash((int) fx + i, (int) fy + j, (int) fz + k);
        }
        return sum;
    }

    private static double hash(int x, int y, int z) {
        int h = x * 0x8da6b343 ^ y * 0xd8163841 ^ z * 0xcb1ab31f;
        h ^= h >>> 15;
        h *= 0x2c1b3c6d;
        h ^= h >>> 12;
        h *= 0x297a2d39;
        h ^= h >>> 15;
        return h / 2147483648.0;
    }
}
