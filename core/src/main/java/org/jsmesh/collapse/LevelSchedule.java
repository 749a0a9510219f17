package org.jsmesh.collapse;

import java.util.Arrays;

/**
 * The thresholds of the levels (section 4 of Chen and Nishita 2002: passes are repeated within a level until it is
 * exhausted, then the threshold rises).
 *
 * <p>The first threshold is a percentile of the costs of the original; each further one is four times higher. Levels
 * count from 0 at the original.
 */
public final class LevelSchedule {
    private static final double GROWTH = 4;

    /** Share of the collapses of the original that cost no more than the first threshold. */
    public static final double FIRST_PERCENTILE = 0.1;

    private static final double SMALLEST = 1e-30;

    /**
     * Visits to vertices, for each one and for any mesh, that all passes may take. A pass of an ordinary mesh removes a
     * share of the vertices that are left. Where each removes only some, the mesh stays as it is after so many.
     */
    private static final int MOST_VISITS = 256;

    private static final long FEW_VISITS = 1 << 24;

    private double[] thresholds = new double[16];
    private int level;

    /** @param first cost at the {@link #FIRST_PERCENTILE} */
    public LevelSchedule(double first) {
        thresholds[0] = Math.max(SMALLEST, first);
    }

    /** Visits to vertices that all passes over a mesh of so many may take. */
    static long visits(int vertices) {
        return FEW_VISITS + (long) MOST_VISITS * vertices;
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

    /**
     * Opens the next level unless a cost belongs to the one open now. Leaves out levels that would still be below the
     * cost.
     */
    public void reach(double cost) {
        double threshold = threshold();
        if (cost <= threshold) return;
        while (threshold < cost) threshold *= GROWTH;
        if (++level == thresholds.length) thresholds = Arrays.copyOf(thresholds, 2 * level);
        thresholds[level] = threshold;
    }
}
