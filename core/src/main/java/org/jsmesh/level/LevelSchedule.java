package org.jsmesh.level;

import java.util.Arrays;

/**
 * The thresholds of the levels (section 4 of Chen and Nishita 2002: passes are repeated within a level until it is exhausted, then the threshold rises).
 *
 * <p>The first threshold is a percentile of the costs of the original; each further one is {@value #GROWTH} times higher. A level ends with a pass that
 * removes less than {@value #LEAST_YIELD} of the vertices. Levels count from 0 at the original.
 */
public final class LevelSchedule {
    private static final double GROWTH = 4;
    private static final double LEAST_YIELD = 0.03;
    private static final double FIRST_PERCENTILE = 0.1;
    private static final double SMALLEST = 1e-30;

    private double[] thresholds = new double[16];
    private int level = -1;

    /** @param sortedCosts costs of all possible collapses of the original, ascending, at least one */
    public static double firstThreshold(float[] sortedCosts) {
        return Math.max(SMALLEST, sortedCosts[(int) (sortedCosts.length * FIRST_PERCENTILE)]);
    }

    /** Opens the first level. */
    public LevelSchedule(double firstThreshold) {
        open(firstThreshold);
    }

    /** The level open now. */
    public int level() {
        return level;
    }

    /** Cost up to which collapses belong to the level open now. */
    public double threshold() {
        return thresholds[level];
    }

    /** Thresholds of the levels so far. */
    public double[] thresholds() {
        return Arrays.copyOf(thresholds, level + 1);
    }

    /** True when a pass that removed so many of so many vertices ends its level. */
    public boolean isExhausted(int removed, int vertices) {
        return removed < LEAST_YIELD * vertices;
    }

    /** Opens the next level whose threshold reaches a cost. */
    public void advance(double leastCost) {
        double next = threshold() * GROWTH;
        while (next < leastCost) next *= GROWTH;
        open(next);
    }

    private void open(double threshold) {
        level++;
        if (level == thresholds.length) thresholds = Arrays.copyOf(thresholds, 2 * level);
        thresholds[level] = threshold;
    }
}
