package org.jsmesh.test.results;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jsmesh.test.SampleModels;

/**
 * A table of the file of recorded results, with which what is measured is compared. A figure may be worse by
 * {@value #TOLERATED_PERCENT}%; beyond that the file must be changed on purpose. With the system property
 * {@value #PROPERTY} set to {@value #RECORD} the file takes over what is measured.
 */
public final class RecordedResults {
    static final String PROPERTY = "jsm.results";
    static final String RECORD = "record";
    private static final double TOLERATED_PERCENT = .5;

    private final Path file;
    private final String section;
    private final String command;
    private final boolean isRecording;

    /**
     * @param section heading of the table in {@code docs/results/recorded.md}
     * @param command measures and compares, for messages
     */
    public RecordedResults(String section, String command) {
        this(
                SampleModels.project().resolve("docs/results/recorded.md"),
                section,
                command,
                System.getProperty(PROPERTY, "").equals(RECORD));
    }

    RecordedResults(Path file, String section, String command, boolean isRecording) {
        this.file = file;
        this.section = section;
        this.command = command;
        this.isRecording = isRecording;
    }

    /** Reads the recorded rows into a table that has none yet. */
    public ResultTable read(ResultTable empty) throws IOException {
        List<String> lines = Files.readAllLines(file);
        int begin = begin(lines);
        try {
            empty.read(lines.subList(begin, end(lines, begin)));
        } catch (IllegalArgumentException e) {
            throw new IllegalStateException(file + ", \"" + section + "\": " + e.getMessage(), e);
        }
        return empty;
    }

    /**
     * Compares all rows that are measured, or records them. Prints them, and how they changed.
     *
     * @throws AssertionError when a figure is worse, or is not recorded; it names the row, the figure, what it was and
     *     is, and how to accept that
     */
    public void check(ResultTable measured) throws IOException {
        ResultTable recorded = read(new ResultTable(measured.head(), measured.columns()));
        List<String> worse = new ArrayList<>();
        List<ResultColumn> columns = measured.columns();
        for (Map.Entry<String, double[]> row : measured.rows().entrySet()) {
            double[] before = recorded.row(row.getKey());
            if (before == null) {
                worse.add(row.getKey() + ": not recorded yet");
                continue;
            }
            for (int i = 0; i < before.length; i++) {
                ResultColumn column = columns.get(i);
                double now = row.getValue()[i];
                boolean isMissing = Double.isNaN(before[i]) != Double.isNaN(now);
                if (isMissing || column.isWorse(before[i], now, TOLERATED_PERCENT / 100))
                    worse.add(row.getKey() + ", " + column.name() + ": " + change(column, before[i], now));
            }
        }
        System.out.println(section + "\n\n" + String.join("\n", measured.toLines()) + "\n\n"
                + ResultChanges.summary(recorded, measured));
        if (isRecording) record(recorded, measured);
        else if (!worse.isEmpty()) throw new AssertionError(message(worse));
    }

    private static String change(ResultColumn column, double before, double now) {
        String change = named(before) + " before, " + named(now) + " now";
        double percent = 100 * column.change(before, now) - 100;
        return Double.isFinite(percent) ? change + String.format(Locale.ROOT, " (%+.2f%%)", percent) : change;
    }

    private static String named(double figure) {
        return Double.isNaN(figure) ? "none" : ResultTable.text(figure);
    }

    private String message(List<String> worse) {
        return worse.size() + " figures of \"" + section + "\" are worse than those in " + file + " by more than "
                + TOLERATED_PERCENT + "%, or not in it:\n  " + String.join("\n  ", worse)
                + "\nMend what made them worse. If they are meant to be so, record them, and commit the file with the"
                + " reason:\n  " + command + " -D" + PROPERTY + "=" + RECORD;
    }

    private void record(ResultTable recorded, ResultTable measured) throws IOException {
        measured.rows().forEach(recorded::put);
        List<String> lines = new ArrayList<>(Files.readAllLines(file));
        int begin = begin(lines);
        lines.subList(begin, end(lines, begin)).clear();
        lines.addAll(begin, recorded.toLines());
        Files.writeString(file, String.join("\n", lines) + "\n");
        System.out.println(section + ": recorded in " + file);
    }

    private int begin(List<String> lines) {
        int at = lines.indexOf("## " + section);
        while (at >= 0 && at < lines.size() && !lines.get(at).startsWith("|")) at++;
        if (at < 0 || at == lines.size())
            throw new IllegalStateException(file + " has no table below a heading \"## " + section + "\": put it back");
        return at;
    }

    private static int end(List<String> lines, int begin) {
        int end = begin;
        while (end < lines.size() && lines.get(end).startsWith("|")) end++;
        return end;
    }
}
