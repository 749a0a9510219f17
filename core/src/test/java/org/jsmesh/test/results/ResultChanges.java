package org.jsmesh.test.results;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;

/** How results changed in all, for whoever weighs one against another. */
final class ResultChanges {
    private ResultChanges() {}

    /** The geometric mean of what each figure is in parts of what it was, over the rows that have both. */
    static String summary(ResultTable before, ResultTable now) {
        StringJoiner means = new StringJoiner(", ", "now / recorded: ", "");
        List<ResultColumn> columns = now.columns();
        for (int i = 0; i < columns.size(); i++) {
            double logarithms = 0;
            int count = 0;
            for (Map.Entry<String, double[]> row : now.rows().entrySet()) {
                double[] old = before.row(row.getKey());
                double change = old == null ? Double.NaN : columns.get(i).change(old[i], row.getValue()[i]);
                if (!Double.isFinite(change) || change <= 0) continue;
                logarithms += Math.log(change);
                count++;
            }
            if (count > 0 && columns.get(i).rule() == ResultColumn.Rule.SMALL)
                means.add(String.format(Locale.ROOT, "%s %.4f", columns.get(i).name(), Math.exp(logarithms / count)));
        }
        return means.toString();
    }
}
