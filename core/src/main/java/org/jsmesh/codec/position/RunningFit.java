package org.jsmesh.codec.position;

/**
 * Two weights of a linear prediction, fitted to what was coded so far by least squares. Errors far above a scale count
 * little (a Cauchy loss), and old ones are forgotten. An encoder and a decoder do the same sums in the same order.
 */
final class RunningFit {
    private static final int EVERY = 3; // value teaches; the others would tell little more, and odd: of both tangents
    private static final double MEMORY = 1000; // values
    private static final double KEEP = 1 - 1 / MEMORY;
    private static final int SOLVE_EVERY = 16;

    /** Weight of the weights at the start. */
    private static final double PRIOR = 20;

    private static final double RIDGE = 1e-4;
    private double first;
    private double second;
    private double xx = PRIOR;
    private double xy;
    private double yy = PRIOR;
    private double xt;
    private double yt;
    private int count;
    private int turn;

    /** @param first weight at the start, and {@code second} the other */
    RunningFit(double first, double second) {
        this.first = first;
        this.second = second;
        xt = PRIOR * first;
        yt = PRIOR * second;
    }

    /** The number between −most and most that is closest to x. */
    static double clip(double most, double x) {
        return Math.max(-most, Math.min(most, x));
    }

    /** The prediction from two features. */
    double predict(double x, double y) {
        return first * x + second * y;
    }

    /**
     * Learns from a value and its features. One of three is taken, from the first on.
     *
     * @param scale errors below it count as in least squares
     */
    void learn(double x, double y, double value, double scale) {
        boolean isTaken = turn == 0;
        turn = isTaken ? EVERY - 1 : turn - 1;
        if (!isTaken) return;
        double error = value - predict(x, y);
        double weight = 1 / (error * error + scale * scale);
        double wx = weight * x;
        double wy = weight * y;
        xx = KEEP * xx + wx * x;
        xy = KEEP * xy + wx * y;
        yy = KEEP * yy + wy * y;
        xt = KEEP * xt + wx * value;
        yt = KEEP * yt + wy * value;
        if (++count < SOLVE_EVERY) return;
        count = 0;
        solve();
    }

    private void solve() {
        double ridge = RIDGE * (xx + yy);
        double a = xx + ridge;
        double b = yy + ridge;
        double determinant = a * b - xy * xy;
        if (!(determinant > 0)) return;
        double s = xt + ridge * first;
        double t = yt + ridge * second;
        first = (s * b - t * xy) / determinant;
        second = (t * a - s * xy) / determinant;
    }
}
