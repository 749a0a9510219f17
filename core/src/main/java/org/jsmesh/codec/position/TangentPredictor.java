package org.jsmesh.codec.position;

import org.jsmesh.codec.lod.LodMesh;

/**
 * Predicts the two coordinates of a new vertex across its ring's normal by one of three: the ring's mean; the mean and
 * fitted parts of how far the vertex that was split lies from it, and the middle of that one's neighbours; the median
 * of {@link Completions}. The second coordinate follows the first along the slant of the ring.
 */
final class TangentPredictor {
    private static final int MEAN = 0;
    private static final int FITTED = 1;
    private static final int MEDIAN = 2;

    /** Part of the ring's slant that is the vertex' own. */
    private static final double SLANT = .85;

    /** Error of a prediction that is not there. */
    private static final double NEVER = 1e9;

    /** One of so many vertices tries a prediction that has been poor. */
    private static final int TRIES = 8;

    private final Ring ring;
    private final Completions completions; // or null
    private final RunningFit fit = new RunningFit(0, 0);
    private final Rivals rivals = new Rivals();
    private int tried;
    private double part; // of a unit that a cell is
    private boolean completes;
    private double x; // features: cells from the mean
    private double y;
    private double fitted; // from the mean
    private double median;
    private double range; // in which the coordinate is expected, by the completions
    private double firstOff; // of the coded coordinate from its fit
    private double meanError;
    private double fittedError;
    private double medianError;

    /** @param dense whether medians of completions are among the predictions */
    TangentPredictor(LodMesh mesh, Ring ring, boolean dense) {
        this.ring = ring;
        completions = dense ? new Completions(mesh, ring) : null;
    }

    /**
     * Turns to the vertex of the ring.
     *
     * @param beyond the vertices beyond the ring's edges
     * @param from index of the first
     * @param unit cells
     */
    void begin(int[] beyond, int from, double unit) {
        part = 1 / unit;
        rivals.turn(ring.size);
        completes = completions != null && (rivals.isThirdClose() || (++tried & TRIES - 1) == 0);
        if (completes) completions.find(beyond, from);
    }

    /** The first coordinate. */
    double first() {
        int axis = ring.first;
        takeFeatures(axis);
        fitted = within(fit.predict(x, y));
        if (completes) compare(completions.firstMedian() - ring.mean[axis], completions.firstRange());
        return ring.mean[axis] + chosen(rivals.best(0, 0, completes ? 0 : NEVER));
    }

    /** Learns the cell of the first coordinate. */
    void learnFirst(int cell) {
        double off = learn(cell - ring.mean[ring.first]);
        meanError = error(off);
        fittedError = error(firstOff);
        medianError = completes ? error(off - median) : NEVER;
    }

    /** The second coordinate. */
    double second() {
        int axis = ring.second;
        takeFeatures(axis);
        fitted = within(fit.predict(x, y)) + within(ring.slant() * SLANT * firstOff);
        if (completes) compare(completions.secondMedian() - ring.mean[axis], completions.secondRange());
        return ring.mean[axis] + chosen(rivals.best(meanError / 2, fittedError / 2, medianError / 2));
    }

    /** Learns the cell of the second coordinate. */
    void learnSecond(int cell) {
        double off = learn(cell - ring.mean[ring.second]);
        rivals.learn(MEAN, meanError + error(off));
        rivals.learn(FITTED, fittedError + error(off - fitted));
        if (completes) rivals.learn(MEDIAN, medianError + error(off - median));
    }

    /** Measure of how far the coordinate on an axis is expected from its prediction, in cells. */
    double size(int axis) {
        double size = 7 * ring.spread[axis] + ring.width;
        return completes ? size / 40 + range : size / 2;
    }

    private void takeFeatures(int axis) {
        x = ring.last(axis);
        y = ring.besideLast(axis);
    }

    private void compare(double middle, double between) {
        median = middle;
        range = Math.abs(middle - fitted) + 2 * between;
    }

    private double chosen(int which) {
        return which == MEAN ? 0 : which == FITTED ? fitted : median;
    }

    /** Learns how far a coordinate is from the mean. */
    private double learn(double off) {
        firstOff = off - fitted;
        fit.learn(part * x, part * y, part * off, .05 * ring.width * part + .3);
        return off;
    }

    private double error(double cells) {
        return Rivals.error(part * cells);
    }

    private double within(double cells) {
        return RunningFit.clip(ring.width, cells);
    }
}
