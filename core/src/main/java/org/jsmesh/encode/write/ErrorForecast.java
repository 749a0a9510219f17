package org.jsmesh.encode.write;

/**
 * Predicts the error of levels of detail with exact positions, in % of the diagonal, from the last two that were
 * measured. The error falls by a power of the number of vertices.
 */
final class ErrorForecast {
    private static final double LEAST_POWER = 0.7;
    private static final double MOST_POWER = 1.3;
    private double error; // of the level last measured
    private int vertices;
    private double power = 1;

    /** Notes the error of a level of so many vertices. */
    void measured(double now, int count) {
        if (now > 0 && error > 0 && count > vertices) {
            double fall = StrictMath.log(error / now) / StrictMath.log((double) count / vertices);
            power = Math.max(LEAST_POWER, Math.min(MOST_POWER, fall));
        }
        error = now;
        vertices = count;
    }

    /** The predicted error of a level of so many vertices. */
    double expected(int count) {
        return error * StrictMath.pow((double) vertices / count, power);
    }
}
