package org.jsmesh.load;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/** What a run found, as tables and as conditions that hold or not. */
final class LoadReport {
    private static final double MB = 1e6;
    /** Goal of waits, as a share of T. */
    private static final double WAIT_P95 = 1.02;
    /** The memory of a server that is warm may wander by so much from end to end of the time looked at. */
    private static final double FLAT_MB = 12;

    /** Connections, files and threads that come and go by themselves. */
    private static final int SPARE_FILES = 4;

    /** Time after the last restart that a server needs to become warm. */
    private static final double WARM_SECONDS = 90;

    private final LoadSettings settings;
    private final List<Model> models;
    private final Tally tally;
    private final InjectedFaults faults;
    private final Samples samples;
    private final ProcessFigures before;
    private final ProcessFigures after;
    private final double cpuSeconds;
    private final double sentBytes;
    private final double seconds;
    private final String serverOutput;
    private final Map<String, Boolean> conditions = new LinkedHashMap<>();

    /**
     * @param before when the server had started, and {@code after} when everybody had left
     * @param totals CPU seconds of the server without those of starting, bytes of bodies that it counted, and seconds that the run took
     */
    LoadReport(
            LoadSettings settings,
            List<Model> models,
            Tally tally,
            InjectedFaults faults,
            Samples samples,
            ProcessFigures before,
            ProcessFigures after,
            double[] totals,
            String serverOutput) {
        this.settings = settings;
        this.models = models;
        this.tally = tally;
        this.faults = faults;
        this.samples = samples;
        this.before = before;
        this.after = after;
        cpuSeconds = totals[0];
        sentBytes = totals[1];
        seconds = totals[2];
        this.serverOutput = serverOutput;
        judge();
    }

    /** What must hold, timed figures included. */
    Map<String, Boolean> conditions() {
        return conditions;
    }

    boolean holds() {
        return !conditions.containsValue(false);
    }

    Tally tally() {
        return tally;
    }

    InjectedFaults faults() {
        return faults;
    }

    ProcessFigures before() {
        return before;
    }

    ProcessFigures after() {
        return after;
    }

    String serverOutput() {
        return serverOutput;
    }

    private void judge() {
        conditions.put(
                "every viewer ended with the original",
                tally.wrongEnds == 0 && tally.completedViewers() == tally.started);
        conditions.put("every decoded mesh is the original", tally.decodedWrongly.get() == 0);
        conditions.put("no byte was sent twice", tally.bytesTwice == 0);
        conditions.put("no 5xx but 503 with Retry-After", tally.serverErrors() == 0);
        conditions.put("no answer of another status than asked for", tally.wrongStatuses() == 0);
        conditions.put("no connection broke without a fault of the test", tally.unexplainedBreaks == 0);
        conditions.put(
                "wait p95 ≤ " + WAIT_P95 + " T in every class",
                SpeedClass.ALL.stream()
                        .allMatch(c -> quantile(waits(r -> r.speed() == c && !r.hit()), .95) <= WAIT_P95));
        conditions.put(
                "median wait ≥ .97 T in every class, rounds that end with the original left out",
                SpeedClass.ALL.stream()
                        .map(c -> waits(r -> r.speed() == c && !r.hit() && !r.complete()))
                        .allMatch(w -> w.length == 0 || quantile(w, .5) >= .97));
        conditions.put("descriptors are back where they began", after.openFiles() <= before.openFiles() + SPARE_FILES);
        if (steadySeconds() < 60) return;
        conditions.put("resident memory is flat", isFlat(s -> s.figures().residentBytes() / MB));
        conditions.put("live heap is flat", isFlat(LoadReport::liveHeap));
        conditions.put("direct memory is flat", isFlat(LoadReport::direct));
    }

    private boolean isFlat(ToDoubleFunction<Samples.Sample> megabytes) {
        Samples.Trend trend = steady(megabytes);
        return trend.count() == 0 || trend.perMinute() * steadySeconds() / 60 <= FLAT_MB;
    }

    private static double liveHeap(Samples.Sample s) {
        return s.liveHeapMegabytes() < 0 ? Double.NaN : s.liveHeapMegabytes();
    }

    private static double direct(Samples.Sample s) {
        return s.directBytes() < 0 ? Double.NaN : s.directBytes() / MB;
    }

    private double steadyFrom() {
        double last =
                settings.restartSeconds().stream().mapToDouble(s -> s).max().orElse(0);
        return last + WARM_SECONDS;
    }

    private double steadySeconds() {
        return settings.seconds() - steadyFrom();
    }

    private Samples.Trend steady(ToDoubleFunction<Samples.Sample> quantity) {
        return samples.trend(steadyFrom(), settings.seconds(), quantity);
    }

    private double[] waits(Predicate<Tally.Round> which) {
        return tally.rounds.stream()
                .filter(which)
                .mapToDouble(Tally.Round::waitShare)
                .sorted()
                .toArray();
    }

    private static double quantile(double[] sorted, double share) {
        return sorted.length == 0 ? 0 : sorted[Math.min(sorted.length - 1, (int) (share * sorted.length))];
    }

    /** Prints tables in Markdown. */
    void print(PrintWriter out) {
        line(
                out,
                "%d viewers at a time for %.0f s (%.0f s up to the last end), T = %d ms, seed %d; archives of %s bytes",
                settings.viewers(),
                settings.seconds(),
                seconds,
                settings.waitMillis(),
                settings.seed(),
                models.stream()
                        .map(m -> String.format(Locale.ROOT, "%,d", m.bytes().length))
                        .toList());
        line(out, "");
        line(
                out,
                "| viewers | completed | rounds | wait ÷ T: median before the last | p95 | p99 | detail ÷ oracle: first round | later, mean | p10 | requests per round | rounds hit by faults | wait ÷ T: p95 | detail |");
        line(out, "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        for (SpeedClass c : SpeedClass.ALL) row(out, c.name(), tally.completed.getOrDefault(c, 0), r -> r.speed() == c);
        row(out, "all", tally.completedViewers(), r -> true);
        line(out, "");
        line(out, "| | |");
        line(out, "|---|---:|");
        line(
                out,
                "| viewers started, ended with the original, ended otherwise | %d, %d, %d |",
                tally.started,
                tally.completedViewers(),
                tally.wrongEnds);
        line(out, "| meshes decoded, not the original | %d, %d |", tally.decoded.get(), tally.decodedWrongly.get());
        line(
                out,
                "| faults: viewers' cuts, viewers' stalls, proxy's cuts, proxy's stalls, restarts | %d, %d, %d, %d, %d |",
                faults.viewerCuts.get(),
                faults.viewerStalls.get(),
                faults.proxyCuts.get(),
                faults.proxyStalls.get(),
                faults.outageSeconds().size());
        line(out, "| connections that broke without a fault | %d |", tally.unexplainedBreaks);
        line(out, "| connections given up as nothing came for 6 s | %d |", tally.stallsTimedOut);
        line(
                out,
                "| seconds from SIGTERM to the end of the server; until it answered again | %s; %s |",
                round(tally.stopSeconds),
                round(faults.outageSeconds()));
        line(out, "| requests, answers by status | %d, %s |", tally.requests, tally.statuses);
        line(out, "| bytes of archives received, received twice | %,d, %d |", tally.bodyBytes, tally.bytesTwice);
        line(
                out,
                "| bytes that the server counts as sent, beside those received | %s |",
                format(sentBytes / tally.bodyBytes));
        line(out, "| responses given up between rounds | %d |", tally.givenUp);
        line(
                out,
                "| CPU of the server without starting: seconds, of one core, ms per MB | %.1f, %.0f%%, %.1f |",
                cpuSeconds,
                100 * cpuSeconds / seconds,
                1000 * cpuSeconds / (tally.bodyBytes / MB));
        line(out, "");
        series(out);
        line(out, "");
        conditions.forEach((what, holds) -> line(out, "%s %s", holds ? "holds:" : "FAILS:", what));
        tally.errors.forEach(e -> line(out, "  %s", e));
        out.flush();
    }

    private void row(PrintWriter out, String name, int completed, Predicate<Tally.Round> which) {
        double[] waits = waits(which.and(r -> !r.hit()));
        double[] hit = waits(which.and(Tally.Round::hit));
        double[] later = details(which.and(r -> !r.hit() && !r.first()));
        double requests = tally.rounds.stream()
                .filter(which)
                .mapToInt(Tally.Round::requests)
                .average()
                .orElse(0);
        line(
                out,
                "| %s | %d | %d | %.3f | %.3f | %.3f | %s | %s | %s | %.2f | %d | %.3f | %s |",
                name,
                completed,
                waits.length,
                quantile(waits(which.and(r -> !r.hit() && !r.complete())), .5),
                quantile(waits, .95),
                quantile(waits, .99),
                mean(details(which.and(r -> !r.hit() && r.first()))),
                mean(later),
                format(quantile(later, .1)),
                requests,
                hit.length,
                quantile(hit, .95),
                mean(details(which.and(Tally.Round::hit))));
    }

    private double[] details(Predicate<Tally.Round> which) {
        return tally.rounds.stream()
                .filter(which)
                .mapToDouble(Tally.Round::detailShare)
                .sorted()
                .toArray();
    }

    private static String mean(double[] values) {
        if (values.length == 0) return "–";
        double sum = 0;
        for (double v : values) sum += v;
        return format(sum / values.length);
    }

    private static String format(double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, "%.3f", value);
    }

    private static List<String> round(List<Double> values) {
        return values.stream().map(v -> String.format(Locale.ROOT, "%.1f", v)).toList();
    }

    private void series(PrintWriter out) {
        line(
                out,
                "| at, s | viewers | RSS, MB | live heap, MB | direct, MB | threads | open files | load of the machine |");
        line(out, "|---:|---:|---:|---:|---:|---:|---:|---:|");
        double next = 0;
        for (Samples.Sample s : samples.all()) {
            if (s.seconds() < next) continue;
            next = s.seconds() + settings.seconds() / 20;
            line(
                    out,
                    "| %.0f | %d | %.1f | %s | %s | %d | %d | %.1f |",
                    s.seconds(),
                    s.viewers(),
                    s.figures().residentBytes() / MB,
                    lastLive(s),
                    format(direct(s)),
                    s.figures().threads(),
                    s.figures().openFiles(),
                    s.load1());
        }
        line(
                out,
                "| start | 0 | %.1f | | | %d | %d | |",
                before.residentBytes() / MB,
                before.threads(),
                before.openFiles());
        line(
                out,
                "| everybody gone | 0 | %.1f | | | %d | %d | |",
                after.residentBytes() / MB,
                after.threads(),
                after.openFiles());
        line(out, "");
        if (steadySeconds() < 60) return;
        line(
                out,
                "Slopes from %.0f to %.0f s, per minute: RSS %+.2f MB, live heap %+.2f MB, direct %+.2f MB, threads %+.2f, open files %+.2f.",
                steadyFrom(),
                settings.seconds(),
                steady(s -> s.figures().residentBytes() / MB).perMinute(),
                steady(LoadReport::liveHeap).perMinute(),
                steady(LoadReport::direct).perMinute(),
                steady(s -> s.figures().threads()).perMinute(),
                steady(s -> s.figures().openFiles()).perMinute());
    }

    /** The live heap at that time, or when it was looked at before. */
    private String lastLive(Samples.Sample sample) {
        int live = -1;
        for (Samples.Sample s : samples.all()) {
            if (s.start() == sample.start() && s.seconds() <= sample.seconds() && s.liveHeapMegabytes() >= 0)
                live = s.liveHeapMegabytes();
        }
        return live < 0 ? "–" : "" + live;
    }

    private static void line(PrintWriter out, String format, Object... values) {
        out.printf(Locale.ROOT, format + "%n", values);
    }

    /** Everything for programs. */
    String json() {
        Map<String, Object> root = new LinkedHashMap<>();
        root.put(
                "settings",
                Map.of(
                        "viewers",
                        settings.viewers(),
                        "seconds",
                        settings.seconds(),
                        "waitMillis",
                        settings.waitMillis(),
                        "seed",
                        settings.seed()));
        List<Object> classes = new ArrayList<>();
        for (SpeedClass c : SpeedClass.ALL) {
            double[] waits = waits(r -> r.speed() == c && !r.hit());
            Map<String, Object> row = new LinkedHashMap<>();
            row.put("bitsPerSecond", c.bitsPerSecond());
            row.put("completed", tally.completed.getOrDefault(c, 0));
            row.put("rounds", waits.length);
            row.put("waitMedian", quantile(waits, .5));
            row.put("waitP95", quantile(waits, .95));
            row.put("waitP99", quantile(waits, .99));
            row.put("detailFirst", average(details(r -> r.speed() == c && !r.hit() && r.first())));
            row.put("detailLater", average(details(r -> r.speed() == c && !r.hit() && !r.first())));
            classes.add(row);
        }
        root.put("classes", classes);
        root.put("started", tally.started);
        root.put("completed", tally.completedViewers());
        root.put("wrongEnds", tally.wrongEnds);
        root.put("statuses", tally.statuses);
        root.put("bytes", tally.bodyBytes);
        root.put("bytesTwice", tally.bytesTwice);
        root.put("unexplainedBreaks", tally.unexplainedBreaks);
        root.put("cpuSeconds", cpuSeconds);
        root.put(
                "samples",
                samples.all().stream()
                        .map(s -> new double[] {
                            s.seconds(), s.start(), s.viewers(), s.figures().residentBytes(), s.liveHeapMegabytes(),
                            s.directBytes(), s.figures().threads(), s.figures().openFiles(),
                                    s.figures().cpuSeconds(), s.load1()
                        })
                        .toList());
        root.put("conditions", conditions);
        try {
            return new ObjectMapper().writerWithDefaultPrettyPrinter().writeValueAsString(root);
        } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
            throw new IllegalStateException(e);
        }
    }

    private static double average(double[] values) {
        return java.util.Arrays.stream(values).average().orElse(0);
    }
}
