package org.jsmesh.load;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;

/** A report for people: tables in Markdown, then the conditions. */
final class ReportTables {
    private static final double MB = 1e6;
    private static final int ROWS = 20;

    private final LoadReport report;
    private final LoadSettings settings;
    private final Tally tally;
    private final PrintWriter out;

    ReportTables(LoadReport report, PrintWriter out) {
        this.report = report;
        this.out = out;
        settings = report.settings();
        tally = report.tally();
    }

    void print() {
        List<String> sizes = report.models().stream()
                .map(m -> String.format(Locale.ROOT, "%,d", m.bytes().length))
                .toList();
        line(
                "%d viewers at a time for %.0f s, the last one's end at %.0f s; T = %d ms, HTTP/%s, seed %d; archives of %s bytes",
                settings.viewers(),
                settings.seconds(),
                report.seconds(),
                settings.waitMillis(),
                settings.http2() ? "2" : "1.1",
                settings.seed(),
                sizes);
        line("");
        rounds();
        line("");
        totals();
        line("");
        series();
        line("");
        if (report.hasTrend()) trends();
        report.conditions().forEach((what, holds) -> line("%s %s", holds ? "holds:" : "FAILS:", what));
        tally.errors.forEach(e -> line("  %s", e));
        out.flush();
    }

    private void rounds() {
        line(
                "| viewers | completed | rounds | wait ÷ T: median before the last | p95 | p99 | detail ÷ oracle: first round | later, mean | p10 | requests per round | rounds hit by faults | wait ÷ T: p95 | detail | detail of the rounds after these |");
        line("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        for (SpeedClass c : SpeedClass.ALL) row(c.name(), tally.completed.getOrDefault(c, 0), report.rounds(c));
        row("all", tally.completedViewers(), report.rounds(null));
    }

    private void row(String name, int completed, RoundFigures all) {
        RoundFigures spared = all.spared();
        RoundFigures hit = all.where(Tally.Round::hit);
        RoundFigures later = spared.where(r -> !r.first() && !r.afterHit());
        line(
                "| %s | %d | %d | %s | %s | %s | %s | %s | %s | %.2f | %d | %s | %s | %s |",
                name,
                completed,
                spared.count(),
                share(spared.beforeTheLast().wait(.5)),
                share(spared.wait(.95)),
                share(spared.wait(.99)),
                share(spared.where(Tally.Round::first).meanDetail()),
                share(later.meanDetail()),
                share(later.detail(.1)),
                all.meanRequests(),
                hit.count(),
                share(hit.wait(.95)),
                share(hit.meanDetail()),
                share(spared.where(Tally.Round::afterHit).meanDetail()));
    }

    private void totals() {
        InjectedFaults faults = report.faults();
        ServerFigures server = report.server();
        line("| | |");
        line("|---|---:|");
        line(
                "| viewers started, ended with the original, ended otherwise | %d, %d, %d |",
                tally.started, tally.completedViewers(), tally.wrongEnds);
        line("| meshes decoded, not the original | %d, %d |", tally.decoded.get(), tally.decodedWrongly.get());
        line(
                "| faults: viewers' cuts, resets and stalls, proxy's cuts and stalls, restarts | %d, %d, %d, %d, %d, %d |",
                faults.viewerCuts.get(),
                faults.viewerResets.get(),
                faults.viewerStalls.get(),
                faults.proxyCuts.get(),
                faults.proxyStalls.get(),
                faults.outageSeconds().size());
        line("| connections that broke without a fault | %d |", tally.unexplainedBreaks);
        line("| connections given up as nothing came for 6 s | %d |", tally.stallsTimedOut);
        line(
                "| seconds from SIGTERM to the end of the server; until it answered again | %s; %s |",
                seconds(tally.stopSeconds), seconds(faults.outageSeconds()));
        line("| requests, answers by status | %d, %s |", tally.requests, tally.statuses);
        line("| bytes of archives received, received twice | %,d, %d |", tally.bodyBytes, tally.bytesTwice);
        line("| bytes that the server counts as sent ÷ received | %s |", share(server.sentBytes() / tally.bodyBytes));
        line(
                "| responses given up between rounds; bytes that came all the same of what was given up or reset | %d; %,d |",
                tally.givenUp, tally.lateBytes);
        line(
                "| CPU of the server without starting: seconds, of one core, ms per MB | %.1f, %.0f%%, %.1f |",
                server.cpuSeconds(),
                100 * server.cpuSeconds() / report.seconds(),
                1000 * server.cpuSeconds() / (tally.bodyBytes / MB));
    }

    private void series() {
        line(
                "| at, s | viewers | RSS, MB | live heap, MB | direct, MB | threads | open files | load of the machine | viewers' clock late by, ms |");
        line("|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        double next = 0;
        double late = 0;
        for (Samples.Sample s : report.samples().all()) {
            late = Math.max(late, s.lagMillis());
            if (s.seconds() < next) continue;
            next = s.seconds() + settings.seconds() / ROWS;
            line(
                    "| %.0f | %d | %.1f | %s | %s | %d | %d | %.1f | %.0f |",
                    s.seconds(),
                    s.viewers(),
                    LoadReport.resident(s),
                    lastLive(s),
                    share(LoadReport.direct(s)),
                    s.figures().threads(),
                    s.figures().openFiles(),
                    s.load1(),
                    late);
            late = 0;
        }
        end("start", report.server().before());
        end("everybody gone", report.server().after());
    }

    private void end(String name, ProcessFigures f) {
        line("| %s | 0 | %.1f | | | %d | %d | | |", name, f.residentBytes() / MB, f.threads(), f.openFiles());
    }

    /** The live heap at that time, or when it was looked at before. */
    private String lastLive(Samples.Sample sample) {
        int live = -1;
        for (Samples.Sample s : report.samples().all()) {
            if (s.start() == sample.start() && s.seconds() <= sample.seconds() && s.liveHeapMegabytes() >= 0)
                live = s.liveHeapMegabytes();
        }
        return live < 0 ? "–" : "" + live;
    }

    private void trends() {
        line(
                "Slopes from %.0f to %.0f s, per minute: RSS %s MB, live heap %s MB, direct memory %s MB, threads %s, open files %s.",
                report.steadyFrom(),
                settings.seconds(),
                slope(LoadReport::resident),
                slope(LoadReport::liveHeap),
                slope(LoadReport::direct),
                slope(s -> s.figures().threads()),
                slope(s -> s.figures().openFiles()));
        line("");
    }

    private String slope(ToDoubleFunction<Samples.Sample> quantity) {
        Samples.Trend trend = report.trend(quantity);
        return trend.count() < 2 ? "–" : String.format(Locale.ROOT, "%+.2f", trend.perMinute());
    }

    private static String share(double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, "%.3f", value);
    }

    private static List<String> seconds(List<Double> values) {
        return values.stream().map(v -> String.format(Locale.ROOT, "%.1f", v)).toList();
    }

    private void line(String format, Object... values) {
        out.printf(Locale.ROOT, format + "%n", values);
    }
}
