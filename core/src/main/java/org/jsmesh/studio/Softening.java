package org.jsmesh.studio;

/**
 * A slight blur of all light: along the circles of latitude, then along the meridians, by the same angle around the
 * axis. So it is weaker towards the poles, as it is in three.js; a lamp at the zenith stays bright.
 */
final class Softening {
    private static final int TAPS_PER_DEVIATION = 3;
    private static final int DEVIATIONS = 3;
    private static final int REACH = DEVIATIONS * TAPS_PER_DEVIATION;

    private final double[] sines = new double[REACH + 1];
    private final double[] cosines = new double[REACH + 1];
    private final double[] weights = new double[REACH + 1];

    private Softening(double deviation) {
        double sum = 0;
        for (int i = 0; i <= REACH; i++) {
            double deviations = (double) i / TAPS_PER_DEVIATION;
            sines[i] = StrictMath.sin(deviations * deviation);
            cosines[i] = StrictMath.cos(deviations * deviation);
            weights[i] = StrictMath.exp(-deviations * deviations / 2);
            sum += i == 0 ? weights[i] : 2 * weights[i];
        }
        for (int i = 0; i <= REACH; i++) weights[i] /= sum;
    }

    /**
     * @param size of the result
     * @param deviation of the normal distribution, in radians
     */
    static CubePicture of(CubePicture picture, int size, double deviation) {
        Softening softening = new Softening(deviation);
        CubePicture around = CubePicture.of(size, d -> softening.alongLatitude(picture, d));
        return CubePicture.of(size, d -> softening.alongMeridian(around, d));
    }

    private double alongLatitude(CubePicture picture, double[] d) {
        double sum = weights[0] * picture.at(d);
        for (int i = 1; i <= REACH; i++) {
            double x = d[2] * sines[i];
            double z = d[0] * sines[i];
            sum += weights[i] * picture.at(cosines[i] * d[0] + x, d[1], cosines[i] * d[2] - z);
            sum += weights[i] * picture.at(cosines[i] * d[0] - x, d[1], cosines[i] * d[2] + z);
        }
        return sum;
    }

    private double alongMeridian(CubePicture picture, double[] d) {
        double flat = Math.max(1e-9, StrictMath.hypot(d[0], d[2]));
        double sum = weights[0] * picture.at(d);
        for (int i = 1; i <= REACH; i++) {
            double side = d[1] / flat * sines[i];
            double up = flat * sines[i];
            sum += weights[i]
                    * picture.at((cosines[i] - side) * d[0], cosines[i] * d[1] + up, (cosines[i] - side) * d[2]);
            sum += weights[i]
                    * picture.at((cosines[i] + side) * d[0], cosines[i] * d[1] - up, (cosines[i] + side) * d[2]);
        }
        return sum;
    }
}
