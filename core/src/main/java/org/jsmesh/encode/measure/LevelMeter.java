package org.jsmesh.encode.measure;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.encode.write.ErrorMeter;
import org.jsmesh.mesh.Mesh;

/**
 * Measures the levels of one archive. Points of the original, always the same ones, are measured against every level;
 * all of them for a thorough sounding, some for the others, whose mean is then corrected by how far off these points
 * were in the thorough soundings before and after. From levels to the original, distances are much the same but for
 * coarse levels; points of these are gathered and measured all at once in the end.
 */
public final class LevelMeter implements ErrorMeter {
    private static final int POINTS = 2100;

    /** Of so many points one is enough for soundings that are not thorough. */
    private static final int STEP = 3;

    private static final int BACK_POINTS = 900;
    private static final int STREWN = 8;

    /** Levels with fewer faces, or with less than a part of the original's, are measured in both directions. */
    private static final int FEW_FACES = 6000;

    private static final int PART = 10;

    private final float[] positions;
    private final int[] triangles;
    private final double percent; // of the diagonal per length
    private final PointField shown;
    private final PointField exact;
    private final List<Level> levels = new ArrayList<>();
    private int lastStep = 1; // between the points of the last sounding

    /** @param surface of the original */
    public LevelMeter(Mesh original, int[] triangles, SurfacePoints surface) {
        positions = original.positions();
        this.triangles = triangles;
        double[] points = surface.take(POINTS, STREWN);
        shown = new PointField(points);
        exact = new PointField(points);
        float[] box = original.bounds();
        double squares = 0;
        for (int a = 0; a < 3; a++) squares += ((double) box[a + 3] - box[a]) * ((double) box[a + 3] - box[a]);
        percent = squares > 0 ? 100 / Math.sqrt(squares) : 0;
    }

    private static final class Level implements Sounding {
        double some; // mean distance of every STEP-th point
        double mean; // of all, and in the end of both directions
        double largest;
        boolean thorough;
        double[] back; // points of the level, or null

        @Override
        public double mean() {
            return mean;
        }

        @Override
        public double largest() {
            return largest;
        }
    }

    @Override
    public Sounding sound(LodSurface surface, boolean thorough) {
        Level level = new Level();
        lastStep = thorough ? 1 : STEP;
        shown.measure(surface.positions(), surface.triangles(), lastStep);
        level.some = mean(shown.distances(), 0, shown.size(), STEP) * percent;
        level.mean = level.some;
        level.largest = largest(shown.distances(), 0, shown.size(), STEP) * percent;
        if (thorough) {
            level.thorough = true;
            level.mean = mean(shown.distances(), 0, shown.size(), 1) * percent;
            level.largest = largest(shown.distances(), 0, shown.size(), 1) * percent;
            if (surface.faces() <= Math.max(FEW_FACES, triangles.length / 3 / PART))
                level.back = new SurfacePoints(surface.positions(), surface.triangles()).take(BACK_POINTS, STREWN);
        }
        levels.add(level);
        return level;
    }

    @Override
    public Sounding soundMoved(LodSurface.Places places, boolean wholly) {
        Level level = new Level();
        int step = wholly ? lastStep : STEP;
        shown.measureMoved(places, step);
        level.some = mean(shown.distances(), 0, shown.size(), step) * percent;
        level.largest = largest(shown.distances(), 0, shown.size(), step) * percent;
        level.thorough = step == 1;
        level.mean = level.some;
        levels.add(level);
        return level;
    }

    @Override
    public double mean(LodSurface surface) {
        exact.measure(surface.positions(), surface.triangles(), STEP);
        return mean(exact.distances(), 0, exact.size(), STEP) * percent;
    }

    @Override
    public void finish() {
        measureBack();
        Level before = null;
        for (int i = 0; i < levels.size(); ) {
            int next = i;
            while (next < levels.size() && !levels.get(next).thorough) next++;
            Level after = next < levels.size() ? levels.get(next) : null;
            for (int k = i; k < next; k++) correct(levels.get(k), before, after, (k - i + 1.0) / (next - i + 1));
            before = after;
            i = next + 1;
        }
    }

    /** Corrects a level that was not measured thoroughly by those before and after it, the latter to a part. */
    private static void correct(Level level, Level before, Level after, double part) {
        double first = ratio(before, after);
        double second = ratio(after, before);
        level.mean = level.some * StrictMath.pow(first, 1 - part) * StrictMath.pow(second, part);
        if (before != null && before.mean > 0)
            level.largest = Math.max(level.largest, before.largest * Math.min(1, level.mean / before.mean));
    }

    private static double ratio(Level level, Level other) {
        Level known = level != null ? level : other;
        return known == null || !(known.mean > 0) || !(known.some > 0) ? 1 : known.mean / known.some;
    }

    /** Measures the points of all coarse levels. */
    private void measureBack() {
        List<Level> coarse = new ArrayList<>();
        for (Level level : levels) if (level.back != null) coarse.add(level);
        if (coarse.isEmpty()) return;
        double[] points = new double[3 * BACK_POINTS * coarse.size()];
        for (int i = 0; i < coarse.size(); i++)
            System.arraycopy(coarse.get(i).back, 0, points, 3 * BACK_POINTS * i, 3 * BACK_POINTS);
        PointField field = new PointField(points);
        for (int i = 0; i < field.size(); i++) field.distances()[i] = coarse.get(i / BACK_POINTS).mean / percent;
        field.measure(positions, triangles, 1);
        for (int i = 0; i < coarse.size(); i++) {
            Level level = coarse.get(i);
            int from = BACK_POINTS * i;
            level.mean = (level.mean + mean(field.distances(), from, from + BACK_POINTS, 1) * percent) / 2;
            level.largest = Math.max(level.largest, largest(field.distances(), from, from + BACK_POINTS, 1) * percent);
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
