package org.jsmesh.load;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A report for programs. */
final class ReportJson {
    private ReportJson() {}

    static String of(LoadReport report) {
        Tally tally = report.tally();
        Map<String, Object> root = new LinkedHashMap<>();
        root.put("settings", report.settings());
        root.put("seconds", report.seconds());
        root.put("classes", SpeedClass.ALL.stream().map(c -> speed(report, c)).toList());
        root.put("started", tally.started);
        root.put("completed", tally.completedViewers());
        root.put("wrongEnds", tally.wrongEnds);
        root.put("statuses", tally.statuses);
        root.put("bytes", tally.bodyBytes);
        root.put("bytesTwice", tally.bytesTwice);
        root.put("lateBytes", tally.lateBytes);
        root.put("unexplainedBreaks", tally.unexplainedBreaks);
        root.put("outageSeconds", report.faults().outageSeconds());
        root.put("serverCpuSeconds", report.server().cpuSeconds());
        root.put("samples", samples(report));
        root.put("conditions", report.conditions());
        try {
            return new ObjectMapper().writerWithDefaultPrettyPrinter().writeValueAsString(root);
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("maps of numbers and texts", e);
        }
    }

    private static Map<String, Object> speed(LoadReport report, SpeedClass speed) {
        RoundFigures spared = report.rounds(speed).spared();
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("bitsPerSecond", speed.bitsPerSecond());
        row.put("completed", report.tally().completed.getOrDefault(speed, 0));
        row.put("rounds", spared.count());
        row.put("waitMedianBeforeTheLast", spared.beforeTheLast().wait(.5));
        row.put("waitP95", spared.wait(.95));
        row.put("waitP99", spared.wait(.99));
        row.put("detailFirst", spared.where(Tally.Round::first).meanDetail());
        row.put("detailLater", spared.where(r -> !r.first()).meanDetail());
        row.put("requests", report.rounds(speed).meanRequests());
        return row;
    }

    private static List<Object> samples(LoadReport report) {
        List<Object> rows = new ArrayList<>();
        for (Samples.Sample s : report.samples().all()) {
            Map<String, Object> row = new LinkedHashMap<>();
            row.put("seconds", s.seconds());
            row.put("start", s.start());
            row.put("viewers", s.viewers());
            row.put("figures", s.figures());
            row.put("liveHeapMegabytes", s.liveHeapMegabytes());
            row.put("directBytes", s.directBytes());
            row.put("load1", s.load1());
            row.put("lagMillis", s.lagMillis());
            rows.add(row);
        }
        return rows;
    }
}
