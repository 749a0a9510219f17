package org.jsmesh.desktop.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.archive.PlainText;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.session.SessionProgress;

/**
 * The figures of a model and of its loading, in rows of a table, and the words for what was proven and what was lost.
 */
final class Statistics {
    private static final int MOST_NAME = 40;

    /** What is off by no more cannot be told from the original. */
    private static final double UNSEEN_PIXELS = .5;

    /** A row of the table. */
    record Row(String name, String value) {}

    private Statistics() {}

    /**
     * The table.
     *
     * @param batch after which the resolution is that is shown, −1 for none
     * @param pixels that the model's diagonal is long where it is nearest to the eye; NaN when it is not known
     * @param heapBytes that this program uses
     */
    static List<Row> rows(ModelFacts facts, int batch, double pixels, long heapBytes, long mostHeapBytes) {
        List<Row> rows = new ArrayList<>();
        SessionProgress p = facts.progress();
        ArchiveHeader h = facts.header();
        if (h != null) {
            rows.add(new Row("Faces", of(p == null ? 0 : p.faces(), h.faces())));
            rows.add(new Row("Vertices", ofVertices(facts, h)));
            rows.add(new Row("Wedges", Figures.count(h.wedges())));
        }
        if (p != null) rows.add(new Row("Bytes", of(p.bytes(), p.totalBytes())));
        if (h != null && p != null) {
            rows.add(new Row("Batches", of(p.batches(), p.totalBatches())));
            rows.add(new Row("Levels", of(p.level(), h.levels().size())));
        }
        if (h != null && batch >= 0) error(h.batches(), batch, pixels, rows);
        if (facts.rounds() > 0) rows.add(new Row("Rounds", Figures.count(facts.rounds())));
        if (p != null && p.bytesPerSecond() > 0)
            rows.add(new Row("Throughput", Figures.bytes(Math.round(p.bytesPerSecond())) + "/s"));
        if (h != null) archive(h, rows);
        rows.add(new Row("Memory", Figures.bytes(heapBytes) + " of " + Figures.bytes(mostHeapBytes)));
        return rows;
    }

    /** How far the resolution that is shown is off, and whether that can be seen. */
    private static void error(BatchIndex index, int batch, double pixels, List<Row> rows) {
        double quantile = index.errorQuantile(batch);
        rows.add(new Row("Mean error", Figures.percent(index.errorMean(batch))));
        rows.add(new Row("99.9% within", Figures.percent(quantile)));
        rows.add(new Row("All within", Figures.percent(index.errorBound(batch))));
        if (Double.isNaN(pixels)) return;
        double off = quantile / 100 * pixels;
        String size = String.format(Locale.ROOT, off < 9.95 ? "off by %.1f pixels" : "off by %.0f pixels", off);
        rows.add(new Row("At this size", off <= UNSEEN_PIXELS ? "as good as the original" : size));
    }

    private static void archive(ArchiveHeader h, List<Row> rows) {
        if (h.faces() > 0) {
            double bits = 8.0 * h.batches().archiveBytes() / h.faces();
            rows.add(new Row("Bits per face", String.format(Locale.ROOT, "%.1f", bits)));
        }
        if (!h.channels().isEmpty())
            rows.add(new Row(
                    "Attributes",
                    h.channels().stream()
                            .map(c ->
                                    c.name().isEmpty() ? c.semantic().name().toLowerCase(Locale.ROOT) : name(c.name()))
                            .collect(Collectors.joining(", "))));
        if (!h.faceChannels().isEmpty())
            rows.add(new Row(
                    "Of faces",
                    h.faceChannels().stream().map(c -> name(c.name())).collect(Collectors.joining(", "))));
        if (!h.materials().isEmpty())
            rows.add(new Row("Materials", Figures.count(h.materials().size())));
        if (!h.images().isEmpty())
            rows.add(new Row("Images", Figures.count(h.images().size())));
        if (!h.provenance().format().isEmpty())
            rows.add(new Row("File", h.provenance().format()));
        if (h.up() != UpAxis.UNKNOWN) rows.add(new Row("Up", h.up().name().toLowerCase(Locale.ROOT)));
        rows.add(new Row("Closed", h.isClosed() ? "yes" : "no"));
        rows.add(new Row("Size", size(h.bounds())));
    }

    /** Of a channel, which may hold anything. */
    private static String name(String given) {
        return PlainText.fit(given, MOST_NAME);
    }

    private static String size(float[] bounds) {
        return String.format(
                Locale.ROOT, "%.3g × %.3g × %.3g", bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5] - bounds[2]);
    }

    private static String ofVertices(ModelFacts facts, ArchiveHeader h) {
        int shown = facts.batches() == 0 ? 0 : h.batches().vertices(facts.batches() - 1);
        return of(shown, h.vertices());
    }

    private static String of(long part, long all) {
        return all > 0 ? Figures.count(part) + " of " + Figures.count(all) : Figures.count(part);
    }

    /** What was proven; empty before the end. */
    static String proof(ModelFacts facts) {
        if (facts.result() == null || facts.header() == null) return "";
        if (!facts.result().identical())
            return "Not the original: " + facts.result().difference() + ".";
        return "Proven: " + OriginalWords.claim(facts.header().provenance()) + ". SHA-256 of the decoded mesh: "
                + facts.result().meshSha256() + "; of mesh and pictures: "
                + facts.header().modelSha256() + "; of the archive: "
                + facts.result().archiveSha256() + ".";
    }

    /** The notes, a line each; empty for none. */
    static String notes(ModelFacts facts) {
        return facts.notes().stream().map(Statistics::sentence).collect(Collectors.joining("\n"));
    }

    private static String sentence(Note note) {
        String where = note.example().isEmpty() ? "" : " First: " + note.example() + ".";
        return (note.warning() ? "⚠ " : "") + note.text() + where;
    }
}
