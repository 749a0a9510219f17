package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.JsonReport;
import org.jsmesh.app.console.Output;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ArchiveReport;
import org.jsmesh.files.ArchiveReport.BatchRow;
import org.jsmesh.files.ArchiveReport.ChannelRow;
import org.jsmesh.files.ArchiveReport.FaceChannelRow;
import org.jsmesh.files.ArchiveReport.LevelRow;
import org.jsmesh.mesh.Note;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code jsm info}: what an archive holds. */
@Command(
        name = "info",
        description = "Shows what an archive holds: totals, attributes, bounds, levels, batches and hashes.",
        footer = {"", "Example: jsm info bunny.jsm --json"})
final class InfoCommand implements Callable<Integer> {
    /** Of a model in a large picture. */
    private static final int PICTURE_PIXELS = 1000;

    @Parameters(paramLabel = "IN.jsm", description = "The archive.")
    private Path in;

    @Mixin
    private JsonReport json;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        ArchiveFile archive = ArchiveInput.read(in);
        ArchiveReport report;
        try {
            report = archive.report();
        } catch (IOException e) {
            throw new CommandFailure(in, e);
        }
        if (!archive.isWhole()) output.note(ArchiveInput.cut(in, archive));
        if (json.isWanted()) output.json(report);
        else print(report, archive.index());
        return 0;
    }

    private void print(ArchiveReport r, BatchIndex index) {
        if (r.faces() == null) output.line("totals, bounds and levels are in the part of the file that is missing");
        else
            output.line(r.faces() + " faces, " + r.vertices() + " vertices, " + r.wedges() + " wedges, " + r.materials()
                    + " materials, " + r.textures() + " textures");
        for (ChannelRow c : r.channels())
            output.line("channel " + c.name() + ": " + c.semantic() + ", " + c.components() + " x " + c.type());
        if (!r.up().equals("unknown")) output.line("the " + r.up() + " axis points up");
        if (r.faces() != null) {
            printWhole(r);
            output.line(HalfPixel.of(index, PICTURE_PIXELS).line(r.bytes()));
            printLevels(r);
        }
        printBatches(r);
    }

    /** What the end of the header says. */
    private void printWhole(ArchiveReport r) {
        List<Number> b = r.bounds();
        output.line("bounds (" + b.get(0) + " " + b.get(1) + " " + b.get(2) + ") to (" + b.get(3) + " " + b.get(4) + " "
                + b.get(5) + ")");
        double[] o = r.origin();
        if (o[0] != 0 || o[1] != 0 || o[2] != 0)
            output.line(
                    "double precision; positions are shown as offsets from (" + o[0] + " " + o[1] + " " + o[2] + ")");
        for (FaceChannelRow c : r.faceChannels())
            output.line("attribute of faces " + c.name() + ": " + c.components() + " x " + c.type());
        output.line(String.format(
                Locale.ROOT,
                "%d bytes, %.2f bits per vertex; base of %d faces in %d bytes (%.2f%%)",
                r.bytes(),
                8.0 * r.bytes() / Math.max(1, r.vertices()),
                r.baseFaces(),
                r.baseBytes(),
                100.0 * r.baseBytes() / r.bytes()));
        output.line("mesh SHA-256    " + r.meshSha256());
        output.line("model SHA-256   " + r.modelSha256() + (r.textures() > 0 ? " (mesh and pictures)" : ""));
        if (r.archiveSha256() != null) output.line("archive SHA-256 " + r.archiveSha256());
        if (!r.sourceFormat().isEmpty()) output.line("from a file of format " + r.sourceFormat());
        for (BatchRow row : r.batches()) {
            if (!row.kind().equals("poster")) continue;
            output.line("poster of " + BatchIndex.payloadBytes(row.bytes()) + " bytes from byte " + row.offset());
        }
        for (Note note : r.notes()) {
            String first = note.example().isEmpty() ? "" : " First: " + note.example() + ".";
            output.line((note.warning() ? "warning: not the whole original: " : "of the file not kept: ")
                    + note.text()
                    + first);
        }
    }

    private void printLevels(ArchiveReport r) {
        output.line("");
        // a level brings back what was removed up to its threshold
        output.line(" level  removed up to      faces   mean error %");
        output.line(String.format(
                Locale.ROOT,
                "     0           base  %9d  %13.5f",
                r.baseFaces(),
                r.batches().get(0).errorMean()));
        for (int i = 0; i < r.levels().size(); i++) {
            LevelRow l = r.levels().get(i);
            output.line(String.format(
                    Locale.ROOT, "%6d  %13.4g  %9d  %13.5f", i + 1, l.threshold(), l.faces(), l.errorMean()));
        }
    }

    private void printBatches(ArchiveReport r) {
        output.line("");
        output.line(
                " batch  kind       offset    bytes  patches      faces   vertices  bits  mean error %  99.9% below %  at most %");
        for (int i = 0; i < r.batches().size(); i++) {
            BatchRow row = r.batches().get(i);
            output.line(String.format(
                    Locale.ROOT,
                    "%6d  %-7s %9d %8d %8d %10d %10d %5d %13.5f  %13.5f  %9.4f",
                    i,
                    row.kind(),
                    row.offset(),
                    row.bytes(),
                    row.patches(),
                    row.faces(),
                    row.vertices(),
                    row.precisionBits(),
                    row.errorMean(),
                    row.errorQuantile(),
                    row.errorBound()));
        }
    }
}
