package org.jsmesh.app.paper;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.app.paper.Drawing.Figure;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.collapse.CollapseMesh;
import org.jsmesh.collapse.PaperSimplifier;
import org.jsmesh.collapse.SimplificationTarget;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** Figures 9 and 10 of the paper. */
final class PaperFigures {
    private final List<StandIn> models;
    private final ProgressListener progress;

    PaperFigures(List<StandIn> models, ProgressListener progress) {
        this.models = models;
        this.progress = progress;
    }

    /** Figure 9: base edges and models, level by level. */
    Figure ninth() throws IOException {
        StandIn bunny = models.get(0);
        List<Double> usual = Levels.USUAL.thresholds();
        Drawing drawing = new Drawing(usual.size() + 2, 2);
        List<List<String>> rows = new ArrayList<>();
        for (int level = 0; level < usual.size() + 2; level++) {
            progress.step("figure9", (double) level / (usual.size() + 2));
            boolean isLast = level > usual.size();
            Levels levels = isLast ? Levels.to(bunny) : new Levels(usual.subList(0, level), 0);
            CollapseMesh collapsing = simplified(bunny.mesh(), levels);
            int reached = Math.max(1, collapsing.log().levels());
            double threshold = level == 0 ? -1 : isLast ? levels.thresholds().get(reached - 1) : usual.get(level - 1);
            List<int[]> edges = BaseEdges.of(bunny.mesh(), threshold);
            Mesh model = Reduction.live(collapsing, new int[bunny.mesh().vertices()]);
            drawing.draw(level, 0, BaseEdges.drawn(bunny.mesh(), edges), bunny);
            drawing.draw(level, 1, model, bunny);
            rows.add(List.of(
                    level == 0 ? "original" : "weights up to " + threshold,
                    Figures.count(edges.size()),
                    Figures.count(model.faces()),
                    Figures.count(model.vertices())));
        }
        return new Figure(
                "figure9",
                "Figure 9: base edges and models by level",
                "The bunny (" + bunny.source()
                        + "), drawn by the renderer of the posters. Above: the edges of the original"
                        + " that are sharp or have a weight above the threshold of the level, whose ends stay; at first"
                        + " all edges. Below: what the paper's method has left after each level. " + Levels.DESCRIBED,
                List.of("level", "base edges", "faces", "vertices"),
                rows,
                drawing.png());
    }

    private static CollapseMesh simplified(Mesh mesh, Levels levels) {
        CollapseMesh collapsing = new CollapseMesh(mesh);
        PaperSimplifier.simplify(
                collapsing, levels.thresholds(), SimplificationTarget.ofFaces(levels.faces()), ProgressListener.NONE);
        return collapsing;
    }

    /** Figure 10: originals and simplified models. */
    Figure tenth() throws IOException {
        Drawing drawing = new Drawing(models.size(), 3);
        List<List<String>> rows = new ArrayList<>();
        for (int i = 0; i < models.size(); i++) {
            progress.step("figure10", (double) i / models.size());
            StandIn model = models.get(i);
            Encoded same = Encoded.of(model.mesh(), Levels.to(model));
            Mesh base = same.withFaces(0);
            Mesh ours = Encoded.of(model.mesh()).withFaces(base.faces());
            drawing.draw(i, 0, model.mesh(), model);
            drawing.draw(i, 1, base, model);
            drawing.draw(i, 2, ours, model);
            BatchIndex index = same.index();
            rows.add(List.of(
                    model.model().label(),
                    Figures.count(index.faces(index.size() - 1)),
                    Figures.count(base.faces()),
                    Figures.count(ours.faces())));
        }
        return new Figure(
                "figure10",
                "Figure 10: originals and simplified models",
                "The models of table 1, drawn by the renderer of the posters. From above: the original, the base of"
                        + " the paper's method, and what an archive of the default simplifier shows as soon as it has at"
                        + " least as many faces as that base. " + Levels.DESCRIBED,
                List.of("model", "original, faces", "paper's method", "default"),
                rows,
                drawing.png());
    }
}
