package org.jsmesh.plan;

/**
 * Exponentially weighted average of rates, weighted by the time over which each was seen, and unbiased from the first
 * sample on (as in hls.js and dash.js).
 */
final class MovingAverage {
    private static final double LN_2 = 0.6931471805599453;
    private final double halfLifeMillis;
    private double sum;
    private double weight;

    MovingAverage(double halfLifeMillis) {
        this.halfLifeMillis = halfLifeMillis;
    }

    void add(double value, double millis) {
        double kept = half(millis / halfLifeMillis);
        sum = kept * sum + (1 - kept) * value;
        weight = 1 - kept + kept * weight;
    }

    void copy(MovingAverage other) {
        sum = other.sum;
        weight = other.weight;
    }

    /** The average, 0 before the first sample. */
    double value() {
        return weight > 0 ? sum / weight : 0;
    }

    /** 2<sup>−x</sup> for x ≥ 0, with + − × ÷ alone, so that every platform computes the same bits. */
    static double half(double x) {
        if (x > 60) return 0;
        int whole = (int) x;
        double exponent = (x - whole) * LN_2;
        double term = 1;
        double power = 1;
        for (int i = 1; i <= 18; i++) {
            term = term * -exponent / i;
            power += term;
        }
        return power / (1L << whole);
    }
}
