package org.jsmesh.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jsmesh.app.console.JsonReport;
import org.jsmesh.app.console.Output;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.simulation.GeometricIndex;
import org.jsmesh.simulation.HttpVersion;
import org.jsmesh.simulation.LinkTrace;
import org.jsmesh.simulation.PlannerComparison;

/** Compares planners on links of all kinds, as a table in Markdown or as JSON. */
final class PlannerTable {
    private static final long ENDLESS_BYTES = 400_000_000;
    private static final int BASE_BYTES = 3000;

    private PlannerTable() {}

    /** Batches as the format allows, so many that no visitor comes to their end. */
    static BatchIndex endless() {
        return GeometricIndex.of(BASE_BYTES, ENDLESS_BYTES);
    }

    static void print(BatchIndex index, JsonReport json, Output output) {
        List<PlannerComparison.Result> rows = new ArrayList<>();
        if (!json.isWanted()) {
            output.line(
                    "| link | HTTP | planner | wait / T: median | p95 | detail in % of an oracle: first round | later: mean | p10 "
                            + "| bytes wasted, % | requests per round |");
            output.line("|---|---|---|---:|---:|---:|---:|---:|---:|---:|");
        }
        for (LinkTrace trace : LinkTrace.all()) {
            for (HttpVersion version : HttpVersion.values()) {
                for (PlannerComparison.Planner planner : PlannerComparison.Planner.values()) {
                    PlannerComparison.Result row = PlannerComparison.run(index, trace, version, planner);
                    rows.add(row);
                    if (!json.isWanted()) output.line(line(row));
                }
            }
        }
        if (json.isWanted()) output.json(rows);
    }

    private static String line(PlannerComparison.Result r) {
        return String.format(
                Locale.ROOT,
                "| %s | %s | %s | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f | %.1f |",
                r.trace(),
                r.version(),
                r.planner(),
                r.waitMedian(),
                r.waitP95(),
                100 * r.first(),
                100 * r.mean(),
                100 * r.p10(),
                100 * r.wasted(),
                r.requests());
    }
}
