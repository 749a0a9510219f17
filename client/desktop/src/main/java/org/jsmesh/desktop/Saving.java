package org.jsmesh.desktop;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.OriginalWords;
import org.jsmesh.desktop.files.ModelAddress;
import org.jsmesh.desktop.panel.Figures;
import org.jsmesh.desktop.panel.ModelFacts;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.ModelExport;
import org.jsmesh.files.OutputFiles;
import org.jsmesh.files.WrittenModel;
import org.jsmesh.mesh.Mesh;

/** Writes a model that is shown into a file, as {@code jsm decode} does. On any thread. */
final class Saving {
    /** What is saved. */
    enum What {
        /** The resolution on the screen. */
        SHOWN,
        /** The original, proven. */
        ORIGINAL,
        /** The archive, every byte of it. */
        ARCHIVE
    }

    private static final String REMEDY = "; load the rest (O), then save again";

    private Saving() {}

    /**
     * Writes the file, whole or not at all.
     *
     * @param batch after which the resolution on the screen is
     * @return what was written and what the file does not hold, in words
     * @throws ViewerException when nothing was written; says why
     */
    static String write(What what, Path file, ModelAddress from, ModelFacts facts, int batch) {
        try {
            requireOther(file, from);
            OutputFiles.requireReplaceable(file);
            return switch (what) {
                case SHOWN -> shown(file, facts, batch);
                case ORIGINAL -> original(file, facts);
                case ARCHIVE -> archive(file, facts);
            };
        } catch (IOException e) {
            throw new ViewerException(Explanation.of(file, e).toString(), e);
        }
    }

    static void requireOther(Path file, ModelAddress from) {
        if (from.kind() != ModelAddress.Kind.REMOTE && OutputFiles.areSame(file, Path.of(from.location())))
            throw new ViewerException(file + ": is the model itself, which would be lost; choose another name");
    }

    private static ModelExport export(Path file) {
        try {
            return ModelExport.to(file);
        } catch (IllegalArgumentException e) {
            throw new ViewerException(file + e.getMessage(), e);
        }
    }

    private static String shown(Path file, ModelFacts facts, int batch) throws IOException {
        ModelExport export = export(file);
        Mesh mesh = new Resolutions(facts.arrived())
                .after(batch, facts.header().batches())
                .mesh();
        WrittenModel written = export.write(mesh, facts.header().up());
        List<String> parts = new ArrayList<>();
        parts.add(
                file + ": " + Figures.count(mesh.faces()) + " faces, " + Figures.count(mesh.vertices()) + " vertices.");
        parts.addAll(written.losses());
        parts.addAll(written.remarks());
        String missing = export.missing(mesh, facts.header().images());
        if (!missing.isEmpty()) parts.add(missing);
        return String.join(" ", parts);
    }

    private static String original(Path file, ModelFacts facts) throws IOException {
        if (facts.result() == null)
            throw new ViewerException(
                    file + ": nothing is written, because the original could not be loaded whole" + REMEDY);
        if (!facts.result().identical())
            throw new ViewerException(file + ": nothing is written, because this is not the original: "
                    + facts.result().difference());
        WrittenModel written =
                export(file).write(facts.result().mesh(), facts.header().up());
        List<String> parts = new ArrayList<>();
        parts.add(
                file + ": " + ModelExport.claim(written.losses(), facts.header().provenance()) + ".");
        parts.addAll(written.remarks());
        String notKept = OriginalWords.notKept(facts.header().provenance());
        if (!notKept.isEmpty()) parts.add("(" + notKept + ")");
        return String.join(" ", parts).replace("..", ".");
    }

    private static String archive(Path file, ModelFacts facts) throws IOException {
        long bytes = facts.arrived().length();
        if (facts.header() == null || bytes != facts.header().batches().archiveBytes())
            throw new ViewerException(
                    file + ": nothing is written, because the archive could not be loaded whole" + REMEDY);
        AtomicFiles.write(file, out -> facts.arrived().writeTo(out));
        return file + ": the archive, " + Figures.bytes(bytes) + ".";
    }
}
