package org.jsmesh.app.paper;

import java.util.List;
import java.util.function.Function;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** Tables 1 and 2 of the paper: what simplification and coding give, and how long they take. */
final class ModelTables {
    private final List<StandIn> models;
    private final Timing timing;
    private final ProgressListener progress;

    ModelTables(List<StandIn> models, Timing timing, ProgressListener progress) {
        this.models = models;
        this.timing = timing;
        this.progress = progress;
    }

    private void step(String table, StandIn model) {
        progress.step(table + ": " + model.model().label(), (double) models.indexOf(model) / models.size());
    }

    /** Table 1: faces, vertices, time. */
    PaperTable first() {
        PaperTable table = new PaperTable(
                "table1",
                "Table 1: original and simplified models",
                "Time is processor time of one thread for simplifying and coding, without reading and writing of"
                        + " files: the median of five runs after a second of warming up. *As text by gzip* is the work of"
                        + " the paper itself: simplifying, writing the simplified model and the patches as text,"
                        + " compressing that. The paper's method has its default thresholds "
                        + Levels.USUAL.thresholds() + "; the paper names none.",
                "Where the model is the paper's own, its method leaves about what the paper's left; stand-ins keep"
                        + " more or fewer faces, because the method keeps the ends of every edge whose normals differ by"
                        + " more than the last threshold, and the default simplifier has no such rule and stops at about"
                        + " the first hundredth of the bytes; times are those of other processors and compilers, and"
                        + " longer for an archive than for text, because levels are measured, and residuals predicted.",
                List.of(
                        "model",
                        "figure",
                        "paper",
                        "jSM, `--simplifier paper`",
                        "÷ paper",
                        "jSM, default",
                        "default ÷ paper"));
        for (StandIn model : models) {
            step("table1", model);
            Mesh mesh = model.mesh();
            PaperModel paper = model.model();
            Encoded same = Encoded.of(mesh, Levels.USUAL);
            Encoded ours = Encoded.of(mesh);
            both(table, model, "faces, original", paper.counts.faces(), faces(same), faces(ours));
            both(table, model, "vertices, original", paper.counts.vertices(), same.vertices(), ours.vertices());
            both(table, model, "faces, simplified", paper.counts.baseFaces(), same.baseFaces(), ours.baseFaces());
            both(
                    table,
                    model,
                    "vertices, simplified",
                    paper.counts.baseVertices(),
                    same.baseVertices(),
                    ours.baseVertices());
            both(
                    table,
                    model,
                    "ms",
                    paper.millis,
                    timing.median(() -> Encoded.of(mesh, Levels.USUAL)),
                    timing.median(() -> Encoded.of(mesh)));
            double text = timing.median(() -> asText(mesh));
            table.row(
                    paper.label(),
                    "ms, as text by gzip",
                    Figures.number(paper.millis),
                    Figures.number(text),
                    Figures.ratio(text, paper.millis),
                    Figures.NONE,
                    Figures.NONE);
        }
        return table;
    }

    private static int faces(Encoded archive) {
        return archive.index().faces(archive.index().size() - 1);
    }

    private static int asText(Mesh mesh) {
        PaperFormat.Streaming text = PaperFormat.of(mesh, Levels.USUAL);
        return PaperText.compressed(text.base()).length + PaperText.compressed(text.allPatches()).length;
    }

    private static void both(PaperTable table, StandIn model, String what, double paper, double same, double ours) {
        table.row(
                model.model().label(),
                what,
                Figures.number(paper),
                Figures.number(same),
                Figures.ratio(same, paper),
                Figures.number(ours),
                Figures.ratio(ours, paper));
    }

    /** Table 2: bytes. */
    PaperTable second() {
        PaperTable table = new PaperTable(
                "table2",
                "Table 2: file sizes",
                "Text is the paper's format, compressed by gzip: the original, the simplified model, and all patches"
                        + " as one file, of which a patch is the mean. A patch is a line: position and attributes of the"
                        + " vertex that comes, the index of face f_t, the index of the split vertex in it, the number of"
                        + " faces to f_r. Of an archive the simplified model is batch 0, the opening and the base; a patch"
                        + " is all that follows it, divided by the vertices that come. Both bring back the mesh with its"
                        + " attributes, bit for bit; the archive has the parameters of its materials too. "
                        + Levels.DESCRIBED,
                "Text differs from the paper's by the attributes that a model's file has, which may be none, and by"
                        + " the digits of a number, here all that bring its bits back; the paper tells neither; an archive"
                        + " saves because an entropy coder gets residuals of predictions instead of digits; the base of"
                        + " the default is smaller still, because it keeps few vertices and gives their last bits later;"
                        + " exact normals come later with either simplifier, so that where patches are few, these carry"
                        + " the normals of the base.",
                List.of(
                        "model",
                        "bytes",
                        "paper",
                        "text, gzip",
                        "÷ paper",
                        "jSM, `--simplifier paper`",
                        "same ÷ paper",
                        "jSM, default",
                        "default ÷ paper"));
        for (StandIn model : models) {
            step("table2", model);
            PaperFormat.Streaming text = PaperFormat.of(model.mesh(), Levels.to(model));
            Encoded same = Encoded.of(model.mesh(), Levels.to(model));
            Encoded ours = Encoded.of(model.mesh());
            PaperModel.Sizes sizes = model.model().sizes;
            double original = PaperText.compressed(PaperFormat.original(model.mesh())).length;
            double patch = (double) PaperText.compressed(text.allPatches()).length
                    / text.patches().size();
            row(table, model, "original", sizes.original(), original, same, ours, e -> (double) e.bytes().length);
            double base = PaperText.compressed(text.base()).length;
            row(table, model, "simplified", sizes.base(), base, same, ours, e -> (double) e.baseBytes());
            row(table, model, "one patch", sizes.patch(), patch, same, ours, Encoded::bytesPerPatch);
        }
        return table;
    }

    private static void row(
            PaperTable table,
            StandIn model,
            String what,
            double paper,
            double text,
            Encoded same,
            Encoded ours,
            Function<Encoded, Double> bytes) {
        table.row(
                model.model().label(),
                what,
                Figures.number(paper),
                Figures.number(text),
                Figures.ratio(text, paper),
                Figures.number(bytes.apply(same)),
                Figures.ratio(bytes.apply(same), paper),
                Figures.number(bytes.apply(ours)),
                Figures.ratio(bytes.apply(ours), paper));
    }
}
