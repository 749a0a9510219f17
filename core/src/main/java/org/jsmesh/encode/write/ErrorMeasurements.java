package org.jsmesh.encode.write;

import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.encode.measure.LevelMeter;
import org.jsmesh.mesh.Mesh;

/**
 * Decides after which batches to measure the error: after most coarse levels, because this takes little time, and after
 * fewer fine ones.
 */
final class ErrorMeasurements {
    /** Growth of the vertices from one thorough measurement to the next. */
    private static final double THOROUGH_GROWTH = 2;

    /** The same from any measurement to the next, while less than a share of all vertices is there, and later. */
    private static final double EARLY_GROWTH = 1.03;

    private static final double EARLY = 0.125;
    private static final double LATE_GROWTH = 1.1;

    /** In a mesh with so many vertices the error falls evenly, and measuring it takes time. */
    private static final int MANY = 100_000;

    private static final double LATE_GROWTH_OF_MANY = 1.25;

    /** Growth from any measurement to the next where time counts for more. */
    private static final double SELDOM = 1.25;

    /** Growth of the vertices before the error with exact positions is measured again. */
    private static final double FORECAST_GROWTH = 1.7;

    /** Share of the vertices from one measurement to the next in a sweep. */
    private static final double SHARE_STEP = 0.04;

    /**
     * Share of coarse vertices below which too few points lie near them. What is left of the error is in proportion to
     * these vertices.
     */
    private static final double LEAST_SHARE = 0.12;

    /** Share of coarse vertices below which as many points as before are needed. */
    private static final double HALF = 0.5;

    private final Mesh original;
    private final MeshCoder coder;
    private final LevelMeter meter;
    private final PrecisionSchedule precision;
    private final BatchIndexBuilder rows;
    private final ErrorCurve curve;
    private final ErrorForecast forecast = new ErrorForecast();
    private double early = EARLY_GROWTH;
    private double late;
    private int measured; // vertices
    private int measuredThoroughly;
    private double shown; // mean error when it was measured last
    private int shownVertices;
    private boolean wasThorough;
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

    /** Makes measurements rarer, so that they take less time and tell less exactly. */
    void measureSeldom() {
        early = SELDOM;
        late = SELDOM;
    }

    /** The error of a base with exact positions. */
    double ofBase(LodSurface base) {
        return meter.meanOf(base);
    }

    /** The predicted error of a level of so many vertices with exact positions. */
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
        double growth = coder.vertices() < EARLY * original.vertices() ? early : late;
        if (coder.vertices() >= growth * measured) measure(coder.vertices() >= THOROUGH_GROWTH * measuredThoroughly);
    }

    /** Measures what is shown after the batch added last, unless it is measured already as well. */
    void measure(boolean thorough) {
        int vertices = coder.vertices();
        if (curve.lastRow() == rows.size() - 1 && (wasThorough || !thorough)) return;
        wasThorough = thorough;
        meter.forget();
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

    /** Makes the next batch of splits be measured. */
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
        meter.forget();
        meter.finish();
        curve.finish(exact);
    }
}
