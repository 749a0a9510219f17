package org.jsmesh.simulation;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;

/**
 * How the rate of a link changes with time. Each seed gives another course of the same kind.
 *
 * @param name as a user writes it
 * @param meanBitsPerSecond rate around which the rate varies, and for which the buffer before the link is made
 * @param isConstant true when the rate never changes
 * @param course draws the rates
 */
public record LinkTrace(String name, double meanBitsPerSecond, boolean isConstant, Course course) {
    private static final double STEP_PERIOD_MILLIS = 3000;
    private static final int COURSE_LENGTH = 4096;

    /** Draws the bits per second over time in milliseconds. */
    public interface Course {
        /**
         * Draws the course of a seed.
         *
         * @param seed any number; the same seed gives the same course
         * @return bits per second at a time in milliseconds from 0 on
         */
        DoubleUnaryOperator bitsPerSecondAt(long seed);
    }

    /**
     * {@return all kinds with a name: links of one rate, links that change between two, and links that vary at random}
     */
    public static List<LinkTrace> all() {
        return List.of(
                constant("64k", 64e3),
                constant("256k", 256e3),
                constant("1M", 1e6),
                constant("10M", 10e6),
                constant("100M", 100e6),
                steps("steps-10-1", 10e6, 1e6),
                steps("steps-1-20", 1e6, 20e6),
                new LinkTrace("lognormal", 4e6, false, LinkTrace::lognormal),
                new LinkTrace("lte", 12e6, false, LinkTrace::lte));
    }

    /**
     * Finds a kind of link.
     *
     * @param name as a user writes it, in lower case except for the M of megabits
     * @return the trace of that name, or null
     */
    public static LinkTrace named(String name) {
        for (LinkTrace trace : all()) if (trace.name.equals(name)) return trace;
        return null;
    }

    /**
     * Makes a link of one rate.
     *
     * @param name for people; it need not be one of {@link #all}
     * @param bitsPerSecond its rate, above 0
     * @return a trace with the same course for every seed
     */
    public static LinkTrace constant(String name, double bitsPerSecond) {
        return new LinkTrace(name, bitsPerSecond, true, seed -> t -> bitsPerSecond);
    }

    private static LinkTrace steps(String name, double firstBitsPerSecond, double secondBitsPerSecond) {
        return new LinkTrace(name, (firstBitsPerSecond + secondBitsPerSecond) / 2, false, seed -> {
            double phase = random(seed).nextDouble() * 2 * STEP_PERIOD_MILLIS;
            return t -> (long) ((t + phase) / STEP_PERIOD_MILLIS) % 2 == 0 ? firstBitsPerSecond : secondBitsPerSecond;
        });
    }

    /**
     * 4 Mbit/s × a lognormal factor of σ = 1. A new factor is drawn every half second, correlated with the one before
     * by .8.
     */
    private static DoubleUnaryOperator lognormal(long seed) {
        double[] rates = varying(random(seed), 4e6, 1, .8);
        return t -> rates[(int) (t / 500) % rates.length];
    }

    /**
     * 12 Mbit/s on average as on a mobile phone: fast and slow fading, drawn every 100 ms, and a handover in 20 s,
     * which leaves a twentieth for half a second to 1.5 s.
     */
    private static DoubleUnaryOperator lte(long seed) {
        Random random = random(seed);
        double[] slow = varying(random, 1, .4, .97);
        double[] fast = varying(random, 1, .35, .5);
        double[] rates = new double[COURSE_LENGTH];
        int fade = 0;
        for (int i = 0; i < rates.length; i++) {
            if (fade > 0) fade--;
            else if (random.nextInt(200) == 0) fade = 5 + random.nextInt(10);
            rates[i] = slow[i] * fast[i] * (fade > 0 ? .05 : 1);
        }
        double scale = 12e6 / Arrays.stream(rates).average().orElseThrow();
        return t -> scale * rates[(int) (t / 100) % rates.length];
    }

    /** Scatters neighbouring seeds, because they would give Randoms that begin alike. */
    private static Random random(long seed) {
        return new Random(seed * 0x9E3779B97F4A7C15L);
    }

    /** Lognormal values around a mean, each correlated with the one before. */
    private static double[] varying(Random random, double mean, double sigma, double correlation) {
        double[] values = new double[COURSE_LENGTH];
        double x = random.nextGaussian();
        for (int i = 0; i < values.length; i++) {
            values[i] = mean * Math.exp(sigma * x - sigma * sigma / 2);
            x = correlation * x + Math.sqrt(1 - correlation * correlation) * random.nextGaussian();
        }
        return values;
    }
}
