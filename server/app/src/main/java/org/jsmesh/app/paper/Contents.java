package org.jsmesh.app.paper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The page that leads to the experiments in a folder. */
final class Contents {
    private Contents() {}

    static String of(Path folder, List<StandIn> models, String machine, String loadBefore, String loadAfter)
            throws IOException {
        StringBuilder text = new StringBuilder("# The paper's experiments, here\n\n");
        text.append(PaperTable.wrapped("Chen and Nishita, *Multiresolution Streaming Mesh with Shape Preserving and"
                + " QoS-like Controlling* (Web3D 2002), has five tables, two figures of results, and in figure 8 the"
                + " diagram of a conversation. `jsm reproduce` runs them with jSM and writes this folder. Each table's"
                + " page has the paper's figures, those measured here, the ratio of both, and why they differ; those of"
                + " figures have what was recorded or drawn here."));
        text.append("\n\n| experiment | files |\n|---|---|\n");
        for (String part : Reproduction.PARTS) {
            Path page = folder.resolve(part + ".md");
            if (!Files.exists(page)) continue;
            String title =
                    Files.readString(page).lines().findFirst().orElse(part).replaceFirst("^# ", "");
            text.append("| [").append(title).append("](").append(part).append(".md) | ");
            String ending = Files.exists(folder.resolve(part + ".csv")) ? ".csv" : ".png";
            text.append('[')
                    .append(part)
                    .append(ending)
                    .append("](")
                    .append(part)
                    .append(ending)
                    .append(") |\n");
        }
        text.append('\n')
                .append(PaperTable.wrapped("Machine of the last run: " + machine + "; load of the system "
                        + loadBefore + " before it and " + loadAfter
                        + " at its end. The paper's was a notebook PC with an Intel"
                        + " Mobile Pentium III of 850 MHz and Java 1.3.1."));
        text.append("\n\nThe models:\n\n| model | paper | here | from |\n|---|---|---|---|\n");
        for (StandIn model : models) {
            PaperModel paper = model.model();
            text.append("| ").append(paper.label()).append(" | ");
            text.append(counts(paper.counts.faces(), paper.counts.vertices())).append(" | ");
            text.append(counts(model.mesh().faces(), model.mesh().vertices())).append(" | ");
            text.append(model.source()).append(" |\n");
        }
        return text.toString();
    }

    private static String counts(int faces, int vertices) {
        return Figures.count(faces) + " faces, " + Figures.count(vertices) + " vertices";
    }
}
