package org.jsmesh.codec.position;

/**
 * Predicts the coordinate of a new vertex along its ring's normal by one of two: the plane of the ring; the plane and
 * fitted parts of how far a smooth surface through the neighbours lies from it. Flat parts of machines need the plane.
 */
final class HeightPredictor {
    private final Ring ring;
    private final RunningFit fit = new RunningFit(1, -.5); // as for a parabola
    private double part; // of a unit that a cell is
    private double flatError;
    private double smoothError;
    private double flat;
    private double smooth;
    private double x;
    private double y;

    HeightPredictor(Ring ring) {
        this.ring = ring;
    }

    /**
     * The coordinate where the other two are p and q.
     *
     * @param normals of the vertices, three numbers each
     * @param unit cells
     */
    double predict(double[] normals, int p, int q, double unit) {
        part = 1 / unit;
        flat = ring.height(p, q);
        ring.measureHeights(normals, p, q);
        double most = 2 * ring.width;
        x = RunningFit.clip(most, ring.height - flat);
        y = RunningFit.clip(most, ring.fall);
        smooth = flat + RunningFit.clip(most, fit.predict(x, y));
        return smoothError < flatError ? smooth : flat;
    }

    /** Learns the cell of the coordinate. */
    void learn(int cell) {
        fit.learn(part * x, part * y, part * (cell - flat), .03 * ring.width * part + .3);
        flatError += (error(cell - flat) - flatError) * Rivals.PART;
        smoothError += (error(cell - smooth) - smoothError) * Rivals.PART;
    }

    /** Measure of how far the coordinate is expected from its prediction, in cells. */
    double size() {
        return 4 * (ring.bend() + .05 * ring.width);
    }

    private double error(double cells) {
        return Rivals.error(part * cells);
    }
}
