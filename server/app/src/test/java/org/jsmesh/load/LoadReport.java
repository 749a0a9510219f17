package org.jsmesh.load;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** What a run found, and whether that is what must be. */
final class LoadReport {
    private static final double MB = 1e6;
    /** Goals of waits, as shares of T. */
    private static final double WAIT_P95 = 1.02;

    private static final double WAIT_MEDIAN = .97;
    /** The memory of a warm server may wander by so much from end to end of the time looked at. */
    private static final double FLAT_MB = 12;

    private static final double FLAT_THREADS = 12;
    /** Viewers have one connection, and for a moment none or a second one. */
    private static final double FLAT_FILES = 25;
    /** Connections and files that come and go by themselves. */
    private static final int SPARE_FILES = 4;
    /** Time after the last restart in which a server becomes warm. */
    private static final double WARM_SECONDS = 90;

    private static final double SHORTEST_TREND_SECONDS = 60;

    private final LoadSettings settings;
    private final List<Model> models;
    private final Tally tally;
    private final InjectedFaults faults;
    private final Samples samples;
    private final ServerFigures server;
    private final double seconds;
    private final Map<String, Boolean> conditions = new LinkedHashMap<>();

    /** @param seconds from the first viewer to the last one's end */
    LoadReport(
            LoadSettings settings,
            List<Model> models,
            Tally tally,
            InjectedFaults faults,
            Samples samples,
            ServerFigures server,
            double seconds) {
        this.settings = settings;
        this.models = models;
        this.tally = tally;
        this.faults = faults;
        this.samples = samples;
        this.server = server;
        this.seconds = seconds;
        judge();
    }

    LoadSettings settings() {
        return settings;
    }

    List<Model> models() {
        return models;
    }

    Tally tally() {
        return tally;
    }

    InjectedFaults faults() {
        return faults;
    }

    Samples samples() {
        return samples;
    }

    ServerFigures server() {
        return server;
    }

    double seconds() {
        return seconds;
    }

    /** What must hold, timed figures included. */
    Map<String, Boolean> conditions() {
        return conditions;
    }

    boolean holds() {
        return !conditions.containsValue(false);
    }

    /** Prints tables in Markdown. */
    void print(PrintWriter out) {
        new ReportTables(this, out).print();
    }

    /** The rounds of one class, or of all. */
    RoundFigures rounds(SpeedClass speed) {
        return RoundFigures.of(tally.rounds, r -> speed == null || r.speed() == speed);
    }

    private void judge() {
        boolean ends = tally.wrongEnds == 0 && tally.completedViewers() == tally.started;
        conditions.put("every viewer ended with the original", ends);
        conditions.put("every decoded mesh is the original", tally.decodedWrongly.get() == 0);
        conditions.put("no byte was sent twice", tally.bytesTwice == 0);
        conditions.put("no 5xx but 503 with Retry-After", tally.serverErrors() == 0);
        conditions.put("no answer of another status than asked for", tally.wrongStatuses() == 0);
        conditions.put("no connection broke without a fault of the test", tally.unexplainedBreaks == 0);
        // Written so that a class without rounds holds.
        conditions.put(
                "wait p95 ≤ " + WAIT_P95 + " T in every class",
                SpeedClass.ALL.stream().noneMatch(c -> rounds(c).spared().wait(.95) > WAIT_P95));
        // Of all classes together: fast links leave few rounds before the last, and these are the odd ones.
        conditions.put(
                "median wait ≥ " + WAIT_MEDIAN + " T, but for rounds that end with the original",
                !(rounds(null).spared().beforeTheLast().wait(.5) < WAIT_MEDIAN));
        int files = server.after().openFiles();
        conditions.put(
                "descriptors are back where they began",
                files <= server.before().openFiles() + SPARE_FILES);
        if (!hasTrend()) return;
        conditions.put("resident memory is flat", isFlat(LoadReport::resident, FLAT_MB));
        conditions.put("live heap is flat", isFlat(LoadReport::liveHeap, FLAT_MB));
        conditions.put("direct memory is flat", isFlat(LoadReport::direct, FLAT_MB));
        conditions.put("threads are flat", isFlat(s -> s.figures().threads(), FLAT_THREADS));
        conditions.put("open files are flat", isFlat(s -> s.figures().openFiles(), FLAT_FILES));
    }

    private boolean isFlat(ToDoubleFunction<Samples.Sample> quantity, double most) {
        double minutes = (settings.seconds() - steadyFrom()) / 60;
        return trend(quantity).perMinute() * minutes <= most;
    }

    static double resident(Samples.Sample s) {
        return s.figures().residentBytes() / MB;
    }

    static double liveHeap(Samples.Sample s) {
        return s.liveHeapMegabytes() < 0 ? Double.NaN : s.liveHeapMegabytes();
    }

    static double direct(Samples.Sample s) {
        return s.directBytes() < 0 ? Double.NaN : s.directBytes() / MB;
    }

    /** Whether the run was long enough to speak of flat memory. */
    boolean hasTrend() {
        return settings.seconds() - steadyFrom() >= SHORTEST_TREND_SECONDS;
    }

    /** When the server is warm after its last restart. */
    double steadyFrom() {
        double last =
                settings.restartSeconds().stream().mapToDouble(s -> s).max().orElse(0);
        return last + WARM_SECONDS;
    }

    /** From then until no new viewers come. */
    Samples.Trend trend(ToDoubleFunction<Samples.Sample> quantity) {
        return samples.trend(steadyFrom(), settings.seconds(), quantity);
    }
}
