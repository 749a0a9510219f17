package org.jsmesh.encode.measure;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.mesh.Mesh;

/**
 * Measures how far the levels of one archive are from the original: distances in % of the diagonal of the original's
 * bounding box. The levels come coarsest first. Points of the original, always the same ones, are measured against
 * every level: all of them for a thorough measurement, some for the others. The mean of some is then corrected by how
 * far off these points were in the thorough measurements before and after. Distances from a level to the original are
 * much the same, except for coarse levels; points of these are gathered and measured all at once in the end.
 */
public final class LevelMeter {
    private static final int POINTS = 2100;

    /** Measurements that are not thorough take one of so many points. */
    private static final int STEP = 3;

    private static final int BACK_POINTS = 900;
    private static final int STREWN = 8;

    /** Levels with fewer faces, or with less than a part of the original's, are measured in both directions. */
    private static final int FEW_FACES = 6000;

    private static final int PART = 10;

    private final StageProgress stages;
    private final float[] positions;
    private final int[] triangles;
    private final double percent; // of the diagonal per length
    private final PointField shown;
    private final PointField exact;
    private final FarPoints far;
    private final List<Measurement> levels = new ArrayList<>();
    private int lastStep = 1; // between the points of the last measurement
    private double farRatio = 1; // of the last quantile to that of the points of the mean alone

    /**
     * @param triangles of the original, three vertices each
     * @param surface of the original
     * @param stages hears of every measurement
     */
    public LevelMeter(Mesh original, int[] triangles, SurfacePoints surface, StageProgress stages) {
        this.stages = stages;
        positions = original.positions();
        this.triangles = triangles;
        double[] points = surface.take(POINTS, STREWN);
        shown = new PointField(points, true);
        exact = new PointField(points);
        far = new FarPoints(surface, triangles.length / 3);
        float[] box = original.bounds();
        double squares = 0;
        for (int a = 0; a < 3; a++) squares += ((double) box[a + 3] - box[a]) * ((double) box[a + 3] - box[a]);
        percent = squares > 0 ? 100 / Math.sqrt(squares) : 0;
    }

    /** The errors of a level. Before the meter has {@linkplain LevelMeter#finish finished}, they are a first guess. */
    public static final class Measurement {
        private double some; // mean distance of every STEP-th point
        private double mean; // mean of all points, and in the end of both directions
        private double largest;
        private double quantile; // 0 when none was looked for
        private double tail; // most of the points are closer
        private boolean thorough;
        private double[] back; // points of the level, or null

        private Measurement() {}

        /** Mean of the distances from either surface to the other, in % of the diagonal. */
        public double mean() {
            return mean;
        }

        /**
         * The distance that 99.9% of either surface does not exceed, in % of the diagonal; 0 when it was not looked
         * for.
         */
        public double quantile() {
            return quantile;
        }

        /** The largest distance found, in % of the diagonal; 0 when none was looked for. */
        public double largest() {
            return largest;
        }
    }

    /** Forgets the surface measured last; before the next one is made. */
    public void forget() {
        shown.forget();
    }

    /**
     * Measures a level as it is shown.
     *
     * @param thorough with all points; the other measurements count in relation to the thorough ones before and after
     */
    public Measurement measure(LodSurface surface, boolean thorough) {
        return stages.during("measuring", () -> measured(surface, thorough));
    }

    private Measurement measured(LodSurface surface, boolean thorough) {
        Measurement level = new Measurement();
        if (isPoint()) return level;
        lastStep = thorough ? 1 : STEP;
        shown.measure(surface.positions(), surface.triangles(), lastStep);
        level.some = mean(shown.distances(), 0, shown.size(), STEP) * percent;
        level.mean = level.some;
        level.largest = largest(shown.distances(), 0, shown.size(), STEP) * percent;
        if (thorough) {
            level.thorough = true;
            double[] sorted = FarPoints.sorted(shown.distances(), 0, shown.size());
            level.tail = FarPoints.far(sorted) * percent;
            level.quantile = far.quantile(surface.positions(), surface.triangles(), sorted) * percent;
            farRatio = level.quantile > 0 ? level.quantile / percent / FarPoints.quantile(sorted) : 1;
            level.mean = mean(shown.distances(), 0, shown.size(), 1) * percent;
            level.largest = largest(shown.distances(), 0, shown.size(), 1) * percent;
            if (surface.faces() <= Math.max(FEW_FACES, triangles.length / 3 / PART))
                level.back = new SurfacePoints(surface.positions(), surface.triangles()).take(BACK_POINTS, STREWN);
        }
        levels.add(level);
        return level;
    }

    /**
     * Measures the level measured last again, after its vertices have moved a little.
     *
     * @param wholly with as many points as before
     */
    public Measurement measureMoved(LodSurface.Places places, boolean wholly) {
        return stages.during("measuring", () -> measuredMoved(places, wholly));
    }

    private Measurement measuredMoved(LodSurface.Places places, boolean wholly) {
        Measurement level = new Measurement();
        if (isPoint()) return level;
        int step = wholly ? lastStep : STEP;
        shown.measureMoved(places, step);
        level.some = mean(shown.distances(), 0, shown.size(), step) * percent;
        level.largest = largest(shown.distances(), 0, shown.size(), step) * percent;
        level.thorough = step == 1;
        level.mean = level.some;
        double[] sorted = FarPoints.sorted(shown.distances(), 0, shown.size());
        if (level.thorough) level.quantile = FarPoints.quantile(sorted) * percent * farRatio;
        levels.add(level);
        return level;
    }

    /** About the mean distance from the original to a level with exact positions, in % of the diagonal. */
    public double meanOf(LodSurface surface) {
        if (isPoint()) return 0;
        return stages.during("measuring", () -> {
            exact.measure(surface.positions(), surface.triangles(), STEP);
            exact.forget();
            return mean(exact.distances(), 0, exact.size(), STEP) * percent;
        });
    }

    /** Is the original without extent? Then so are all levels, and nothing is off. */
    private boolean isPoint() {
        return percent == 0;
    }

    /** Completes all measurements. */
    public void finish() {
        stages.during("measuring", () -> {
            measureBack();
            correctAll();
            return null;
        });
    }

    private void correctAll() {
        Measurement before = null;
        for (int i = 0; i < levels.size(); ) {
            int next = i;
            while (next < levels.size() && !levels.get(next).thorough) next++;
            Measurement after = next < levels.size() ? levels.get(next) : null;
            for (int k = i; k < next; k++) correct(levels.get(k), before, after, (k - i + 1.0) / (next - i + 1));
            before = after;
            i = next + 1;
        }
    }

    /**
     * Corrects a level that was not measured thoroughly by the thorough ones before and after it. The latter has the
     * weight {@code part}.
     */
    private static void correct(Measurement level, Measurement before, Measurement after, double part) {
        double first = ratio(before, after);
        double second = ratio(after, before);
        level.mean = level.some * StrictMath.pow(first, 1 - part) * StrictMath.pow(second, part);
        if (before != null && before.mean > 0)
            level.largest = Math.max(level.largest, before.largest * Math.min(1, level.mean / before.mean));
    }

    private static double ratio(Measurement level, Measurement other) {
        Measurement known = level != null ? level : other;
        return known == null || !(known.mean > 0) || !(known.some > 0) ? 1 : known.mean / known.some;
    }

    /** Measures the points of all coarse levels. */
    private void measureBack() {
        List<Measurement> coarse = new ArrayList<>();
        for (Measurement level : levels) if (level.back != null) coarse.add(level);
        if (coarse.isEmpty()) return;
        double[] points = new double[3 * BACK_POINTS * coarse.size()];
        for (int i = 0; i < coarse.size(); i++)
            System.arraycopy(coarse.get(i).back, 0, points, 3 * BACK_POINTS * i, 3 * BACK_POINTS);
        PointField field = new PointField(points);
        for (int i = 0; i < field.size(); i++) field.distances()[i] = coarse.get(i / BACK_POINTS).mean / percent;
        field.measure(positions, triangles, 1);
        for (int i = 0; i < coarse.size(); i++) {
            Measurement level = coarse.get(i);
            int from = BACK_POINTS * i;
            level.mean = (level.mean + mean(field.distances(), from, from + BACK_POINTS, 1) * percent) / 2;
            level.largest = Math.max(level.largest, largest(field.distances(), from, from + BACK_POINTS, 1) * percent);
            double tail = FarPoints.far(FarPoints.sorted(field.distances(), from, from + BACK_POINTS)) * percent;
            if (tail > level.tail) level.quantile = level.tail > 0 ? level.quantile * tail / level.tail : tail;
            level.back = null;
        }
    }

    private static double mean(double[] distances, int from, int to, int step) {
        double sum = 0;
        int n = 0;
        for (int i = from; i < to; i += step, n++) sum += distances[i];
        return sum / n;
    }

    private static double largest(double[] distances, int from, int to, int step) {
        double largest = 0;
        for (int i = from; i < to; i += step) largest = Math.max(largest, distances[i]);
        return largest;
    }
}
