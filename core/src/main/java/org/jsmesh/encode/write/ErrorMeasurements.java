package org.jsmesh.encode.write;

import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.mesh.Mesh;

/**
 * Decides after which batches the error is measured: most coarse levels, which takes little time, and fewer of the fine
 * ones.
 */
final class ErrorMeasurements {
    /** Growth of the vertices from one thorough measurement to the next. */
    private static final double THOROUGH_GROWTH = 2;

    /** From any measurement to the next, while less than a share of all vertices is there, and later. */
    private static final double EARLY_GROWTH = 1.03;

    private static final double EARLY = 0.125;
    private static final double LATE_GROWTH = 1.1;

    /** Of a mesh with so many vertices the error falls evenly, and measuring it takes time. */
    private static final int MANY = 100_000;

    private static final double LATE_GROWTH_OF_MANY = 1.25;

    /** Growth of the vertices before it is measured again what exact positions would bring. */
    private static final double FORECAST_GROWTH = 1.7;

    /** In sweeps it is measured after this share of the vertices. */
    private static final double SHARE_STEP = 0.04;

    /** Of so few coarse vertices too few points tell; what is left of the error is in proportion to them. */
    private static final double LEAST_SHARE = 0.12;

    /** Of fewer than that many points are needed. */
    private static final double HALF = 0.5;

    private final Mesh original;
    private final MeshCoder coder;
    private final LevelMeter meter;
    private final PrecisionSchedule precision;
    private final BatchIndexBuilder rows;
    private final ErrorCurve curve;
    private final ErrorForecast forecast = new ErrorForecast();
    private final double late; // growth
    private int measured; // vertices
    private int measuredThoroughly;
    private double shown; // mean error when it was measured last
    private int shownVertices;
    private int foreseen;
    private double coarse = 1; // share of the vertices when a sweep was measured last

    ErrorMeasurements(
            Mesh original, MeshCoder coder, LevelMeter meter, PrecisionSchedule precision, BatchIndexBuilder rows) {
        this.original = original;
        this.coder = coder;
        this.meter = meter;
        this.precision = precision;
        this.rows = rows;
        curve = new ErrorCurve(rows, precision);
        late = original.vertices() < MANY ? LATE_GROWTH : LATE_GROWTH_OF_MANY;
    }

    /** The error that a base would have with exact positions. */
    double ofBase(LodSurface base) {
        return meter.meanOf(base);
    }

    /** The error that a level of so many vertices may have, with exact positions. */
    double expected(int vertices) {
        return forecast.expected(vertices);
    }

    /** The mean error of what is shown now, about, in % of the diagonal. */
    double shown() {
        return shownVertices == 0 ? 0 : shown * shownVertices / coder.vertices();
    }

    /** A batch of splits, or the base, was added. */
    void batchEnded() {
        curve.stepped(precision.percent(coder.largestStep()));
        double growth = coder.vertices() < EARLY * original.vertices() ? EARLY_GROWTH : late;
        if (coder.vertices() >= growth * measured) measure(coder.vertices() >= THOROUGH_GROWTH * measuredThoroughly);
    }

    /** Measures what the batch added last shows, if that was not done yet. */
    void measure(boolean thorough) {
        int vertices = coder.vertices();
        if (curve.lastRow() == rows.size() - 1) return;
        if (!precision.isFinest(coder.sweeps().precision()) && vertices >= FORECAST_GROWTH * foreseen) {
            forecast.measured(meter.meanOf(coder.exactSurface(original)), vertices);
            foreseen = vertices;
        }
        LevelMeter.Measurement now = meter.measure(coder.surface(), thorough);
        curve.measured(now);
        shown = now.mean();
        shownVertices = vertices;
        measured = vertices;
        if (thorough) measuredThoroughly = vertices;
    }

    /** A batch of a sweep was added, since the {@linkplain #measure surface was measured}. */
    void moved() {
        double share = (double) coder.sweeps().unrefined() / coder.vertices();
        boolean isEnd = share == 0;
        if (!isEnd && (coarse - share < SHARE_STEP || coder.sweeps().precision() == 0 && share < LEAST_SHARE)) return;
        curve.measured(meter.measureMoved(coder::coordinate, share < HALF));
        coarse = isEnd ? 1 : share;
    }

    /** The next batch of splits is to be measured. */
    void expectChange() {
        measured = 0;
        measuredThoroughly = 0;
        foreseen = 0;
    }

    /**
     * Gives all rows their errors.
     *
     * @param exact first row after which nothing is left of them
     */
    void finish(int exact) {
        meter.finish();
        curve.finish(exact);
    }
}
