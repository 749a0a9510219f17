package org.jsmesh.studio;

import java.util.function.DoubleUnaryOperator;

/**
 * Directions around the z axis at which a function is taken for its weighted mean. They lie on a spiral of golden
 * angles, so that few of them cover the sphere evenly.
 */
final class Taps {
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    /** x, y, z and weight of each; the weights have the sum 1. */
    private final double[] taps;

    /**
     * @param angle from the axis, in radians, of the given share of all taps; weighted by its cosine, not at all beyond
     *     90°
     */
    private Taps(int count, DoubleUnaryOperator angle) {
        taps = new double[4 * count];
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double theta = angle.applyAsDouble((i + .5) / count);
            taps[4 * i] = StrictMath.sin(theta) * StrictMath.cos(i * GOLDEN_ANGLE);
            taps[4 * i + 1] = StrictMath.sin(theta) * StrictMath.sin(i * GOLDEN_ANGLE);
            taps[4 * i + 2] = StrictMath.cos(theta);
            taps[4 * i + 3] = Math.max(0, StrictMath.cos(theta));
            sum += taps[4 * i + 3];
        }
        for (int i = 0; i < count; i++) taps[4 * i + 3] /= sum;
    }

    /**
     * Reflections at the normals of a rough surface that is seen along the axis (Trowbridge and Reitz 1975; weights as
     * by Karis 2013).
     *
     * @param alpha square of the roughness
     */
    static Taps reflections(int count, double alpha) {
        return new Taps(count, share -> 2 * StrictMath.atan(alpha * Math.sqrt(share / (1 - share))));
    }

    /** The weighted mean around a direction of length 1. */
    double mean(CubePicture picture, double[] axis) {
        // A frame around the axis (Duff et al. 2017).
        double sign = axis[2] < 0 ? -1 : 1;
        double a = -1 / (sign + axis[2]);
        double b = axis[0] * axis[1] * a;
        double ux = 1 + sign * axis[0] * axis[0] * a;
        double uy = sign * b;
        double uz = -sign * axis[0];
        double vy = sign + axis[1] * axis[1] * a;
        double vz = -axis[1];
        double sum = 0;
        for (int i = 0; i < taps.length; i += 4) {
            if (taps[i + 3] == 0) continue;
            double x = taps[i];
            double y = taps[i + 1];
            double z = taps[i + 2];
            sum += taps[i + 3]
                    * picture.at(
                            x * ux + y * b + z * axis[0], x * uy + y * vy + z * axis[1], x * uz + y * vz + z * axis[2]);
        }
        return sum;
    }
}
