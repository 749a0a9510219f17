package org.jsmesh.encode.write;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;

/**
 * Computes the quantiles of the errors of all batches from those that were measured. Between two of them the quantile
 * falls with a power of the number of vertices. The last vertices leave hardly any error behind them, so towards all of
 * them it falls with their number: it is that of the places where they are missing. For the same reason it stays within
 * a sweep, while the mean falls with the share of the vertices that are still coarse.
 */
final class QuantileCurve {
    private final BatchIndexBuilder rows;
    private final int end;

    /** @param end first row after which all is exact */
    QuantileCurve(BatchIndexBuilder rows, int end) {
        this.rows = rows;
        this.end = Math.min(end, rows.size());
    }

    /** The quantiles of all rows. They may rise, and be below the means. */
    double[] of(List<ErrorCurve.Support> supports) {
        List<ErrorCurve.Support> known = new ArrayList<>();
        for (ErrorCurve.Support s : supports) if (s.measurement().quantile() > 0 && s.row() < end) known.add(s);
        double[] quantiles = new double[rows.size()];
        for (int k = 0; k < known.size(); k++) {
            boolean last = k + 1 == known.size();
            spread(
                    quantiles,
                    known.get(k),
                    known.get(last ? k : k + 1),
                    last ? end : known.get(k + 1).row());
        }
        hold(quantiles);
        return quantiles;
    }

    /** Sets the quantiles from the row of a measurement to another row, excluded, by the measurement after. */
    private void spread(double[] quantiles, ErrorCurve.Support first, ErrorCurve.Support second, int to) {
        double before = first.measurement().quantile();
        double after = second.measurement().quantile();
        double few = rows.vertices(first.row());
        double many = rows.vertices(second.row());
        boolean toAll = many == rows.vertices(rows.size() - 1);
        for (int row = first.row(); row < to; row++) {
            double now = rows.vertices(row);
            if (many <= few) quantiles[row] = before;
            else if (toAll) quantiles[row] = before + (after - before) * (now - few) / (many - few);
            else
                quantiles[row] =
                        before * StrictMath.pow(after / before, StrictMath.log(now / few) / StrictMath.log(many / few));
        }
    }

    /** Makes the quantile stay from before a sweep until that has ended. */
    private void hold(double[] quantiles) {
        int refined = 0; // vertices
        for (int row = 1; row < end; row++) {
            if (rows.kind(row) == BatchKind.PRECISION) refined += rows.patches(row);
            if (refined == rows.vertices(row)) refined = 0;
            if (refined > 0) quantiles[row] = Math.max(quantiles[row], quantiles[row - 1]);
        }
    }
}
