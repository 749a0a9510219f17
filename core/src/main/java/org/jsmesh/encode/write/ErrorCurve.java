package org.jsmesh.encode.write;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.coding.IndexCoder;
import org.jsmesh.encode.measure.LevelMeter;

/**
 * Computes the errors of all batches from those that were measured. The mean never rises: where the measured mean
 * rises, after vertices were brought back, the values on both sides meet in the middle. Between two measurements it
 * falls by a power of the number of vertices, and in sweeps in proportion to the vertices that are still coarse. The
 * bound is a margin above the largest distances that were measured, or that later splits bridge. The quantile is
 * between them, see {@link QuantileCurve}.
 */
final class ErrorCurve {
    /** Margin above the largest distance that was measured. */
    private static final double MARGIN = 2;

    /** The mean is at least this share of the bound, because a mean of 0 says that all is exact. */
    private static final double LEAST_SHARE = 1e-4;

    /** Half the diagonal of a unit, the largest distance of a coarse vertex from its exact place. */
    private static final double FURTHEST_IN_UNIT = Math.sqrt(3) / 2;

    private final BatchIndexBuilder rows;
    private final PrecisionSchedule precision;
    private final List<Support> supports = new ArrayList<>();
    private double[] steps = new double[64]; // per row: the largest distance that its splits have bridged

    record Support(int row, LevelMeter.Measurement measurement) {}

    ErrorCurve(BatchIndexBuilder rows, PrecisionSchedule precision) {
        this.rows = rows;
        this.precision = precision;
    }

    /** Notes the measurement of the mesh after the batch last added. It takes the place of another one of that. */
    void measured(LevelMeter.Measurement measurement) {
        if (lastRow() == rows.size() - 1) supports.remove(supports.size() - 1);
        supports.add(new Support(rows.size() - 1, measurement));
    }

    /** Notes the largest distance by which the splits of the batch last added moved the surface. */
    void stepped(double percent) {
        int row = rows.size() - 1;
        if (row >= steps.length) steps = java.util.Arrays.copyOf(steps, 2 * row);
        steps[row] = percent;
    }

    /** Row of the last measurement, −1 at first. */
    int lastRow() {
        return supports.isEmpty() ? -1 : supports.get(supports.size() - 1).row;
    }

    /**
     * Sets the errors of all rows, once the meter has finished.
     *
     * @param exact first row after which all is exact
     */
    void finish(int exact) {
        double[] means = new double[rows.size()];
        double[] values = falling();
        for (int k = 0; k < values.length; k++) {
            int from = supports.get(k).row;
            boolean last = k + 1 == values.length;
            spread(means, from, values[k], last ? exact : supports.get(k + 1).row, last ? 0 : values[k + 1]);
        }
        double[] quantiles = new QuantileCurve(rows, exact).of(supports);
        double bound = 0;
        double quantile = 0;
        for (int row = means.length - 1, k = values.length - 1; row >= 0; row--) {
            if (row + 1 < means.length && row + 1 < steps.length) bound = Math.max(bound, MARGIN * steps[row + 1]);
            if (k >= 0 && supports.get(k).row == row)
                bound = Math.max(bound, MARGIN * supports.get(k--).measurement.largest());
            bound = Math.max(bound, Math.max(means[row], precision.percent(coarsestUnit(row)) * FURTHEST_IN_UNIT));
            if (row >= exact) { // nothing is off, though a measurement may find what rounding leaves
                bound = 0;
                continue;
            }
            quantile = Math.max(quantile, quantiles[row]);
            bound = Math.max(bound, quantile);
            double mean = Math.max(means[row], LEAST_SHARE * bound);
            quantile = Math.min(bound, Math.max(quantile, mean));
            rows.error(row, mean, quantile, bound);
        }
    }

    /** Cells of the coarsest unit after a batch; 0 where all positions are exact. */
    private int coarsestUnit(int row) {
        return rows.precisionBits(row) == IndexCoder.EXACT ? 0 : 1 << precision.shift(rows.precisionBits(row));
    }

    /**
     * The measured means, made to fall: pool adjacent violators, with the middle on a logarithmic scale for each pool.
     */
    private double[] falling() {
        int n = supports.size();
        double[] high = new double[n];
        double[] low = new double[n];
        int[] sizes = new int[n];
        int pools = 0;
        for (Support support : supports) {
            high[pools] = low[pools] = support.measurement.mean();
            sizes[pools++] = 1;
            while (pools > 1 && middle(high, low, pools - 2) < middle(high, low, pools - 1)) {
                pools--;
                high[pools - 1] = Math.max(high[pools - 1], high[pools]);
                low[pools - 1] = Math.min(low[pools - 1], low[pools]);
                sizes[pools - 1] += sizes[pools];
            }
        }
        double[] values = new double[n];
        for (int pool = 0, at = 0; pool < pools; pool++)
            for (int i = 0; i < sizes[pool]; i++) values[at++] = middle(high, low, pool);
        return values;
    }

    private static double middle(double[] high, double[] low, int pool) {
        return Math.sqrt(high[pool] * low[pool]);
    }

    /** Sets the means from a row to another one. */
    private void spread(double[] means, int from, double before, int to, double after) {
        int total = 0;
        int end = Math.min(to, means.length - 1);
        for (int row = from + 1; row <= end; row++) total += rows.patches(row);
        boolean grows = end > from && rows.vertices(end) > rows.vertices(from) && after > 0 && before > 0;
        double power = grows
                ? StrictMath.log(before / after) / StrictMath.log((double) rows.vertices(end) / rows.vertices(from))
                : 0;
        means[from] = before;
        int done = 0;
        for (int row = from + 1; row <= end; row++) {
            done += rows.patches(row);
            if (grows) means[row] = before * StrictMath.pow((double) rows.vertices(from) / rows.vertices(row), power);
            else means[row] = after + (before - after) * (total == 0 ? 0 : 1 - (double) done / total);
        }
    }
}
