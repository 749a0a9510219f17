package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.ProgressListener;

/** Tables 4 and 5 of the paper: what is shown while the bunny arrives. */
final class RefinementTables {
    /** Faces, vertices and milliseconds of table 4: simplified, twice between, whole. */
    private static final int[][] RECONSTRUCTED = {
        {531, 302, 2143}, {1145, 609, 4545}, {1739, 906, 6737}, {2915, 1494, 11_182}
    };

    private static final int ORIGINAL_MILLIS = 10_956;

    /** Milliseconds, faces and vertices of table 5, by link. */
    private static final int[][] TRANSMITTED = {{195, 2915, 1494}, {761, 1707, 890}, {2143, 531, 302}};

    /** One between the paper's times over its two faster links, and the wait of the viewers. */
    private static final List<Integer> WAITS = List.of(500, 2000);

    /** Rounds of new clients over a link that is not the slowest, for medians: there the machine counts as well. */
    private static final int ROUNDS = 5;

    private final Served served;
    private final Wire wire;
    private final List<LinkKind> links;
    private final ProgressListener progress;

    RefinementTables(Served served, Wire wire, List<LinkKind> links, ProgressListener progress) {
        this.served = served;
        this.wire = wire;
        this.links = links;
        this.progress = progress;
    }

    /**
     * Table 4: transmission and reconstruction over the slowest link.
     *
     * @param transmission knows how long the original takes as text
     */
    PaperTable fourth(TransmissionTable transmission) throws IOException {
        LinkKind slow = links.get(links.size() - 1);
        PaperTable table = new PaperTable(
                "table4",
                "Table 4: transmission and reconstruction at " + slow.name(),
                "The bunny (" + served.bunny().source() + ") over " + wire.described(List.of(slow))
                        + ". *Original* is table 3's download of the text compressed by gzip, without reading it. The"
                        + " next four are what is decoded when, from before the connection on, by the decoder of the"
                        + " clients at the end of one request; the models between are the first with at least the"
                        + " paper's share of the faces, and the last includes the proof that it is the original."
                        + " *Client* is the client of the viewers, with the same request: the mesh that it shows"
                        + " first, and the proven original.",
                "Times go with the bytes, of which the whole archive has "
                        + Figures.count(served.archive().bytes().length)
                        + " and the paper's simplified model alone 13,644, so that the original is there before its"
                        + " compressed text instead of a little after it; the default's base has few bytes, and is"
                        + " there soon after the connection; the client shows nothing before it has the rest of the"
                        + " header, with counts, hashes and the index of all batches, which comes behind the opening"
                        + " and some batches.",
                List.of("model", "figure", "paper", "here", "÷ paper"));
        progress.step("table4: warm up", 0);
        wire.open();
        for (int i = 0; i < 3; i++) {
            Streams.decoded(served.archive(wire));
            Streams.whole(served.archive(wire));
        }
        progress.step("table4: original", .2);
        double originalMillis = transmission.originalMillis();
        wire.shape(slow);
        progress.step("table4: patches", .5);
        List<Streams.Shown> shown = Streams.decoded(served.archive(wire));
        progress.step("table4: client", .8);
        List<Streams.Shown> client = Streams.whole(served.archive(wire));
        wire.open();
        PaperModel.Counts counts = PaperModel.BUNNY.counts;
        Streams.Shown last = shown.get(shown.size() - 1);
        row(
                table,
                "original",
                counts.faces(),
                counts.vertices(),
                ORIGINAL_MILLIS,
                last.faces(),
                last.vertices(),
                originalMillis);
        for (int i = 0; i < RECONSTRUCTED.length; i++) {
            double share = (double) RECONSTRUCTED[i][0] / counts.faces();
            Streams.Shown model = i == 0 ? shown.get(0) : i == 3 ? last : first(shown, share * last.faces());
            String name = i == 0
                    ? "simplified"
                    : i == 3 ? "reconstructed, all" : "reconstructed, " + Math.round(100 * share) + "% of the faces";
            row(
                    table,
                    name,
                    RECONSTRUCTED[i][0],
                    RECONSTRUCTED[i][1],
                    RECONSTRUCTED[i][2],
                    model.faces(),
                    model.vertices(),
                    model.millis());
        }
        for (int i = 0; i < 2; i++) {
            Streams.Shown model = client.get(i);
            int[] paper = RECONSTRUCTED[i == 0 ? 0 : RECONSTRUCTED.length - 1];
            String name = i == 0 ? "client, first" : "client, original";
            row(table, name, paper[0], paper[1], paper[2], model.faces(), model.vertices(), model.millis());
        }
        return table;
    }

    private static Streams.Shown first(List<Streams.Shown> shown, double faces) {
        for (Streams.Shown s : shown) if (s.faces() >= faces) return s;
        return shown.get(shown.size() - 1);
    }

    private static void row(
            PaperTable table,
            String model,
            int paperFaces,
            int paperVertices,
            int paperMillis,
            int faces,
            int vertices,
            double millis) {
        cell(table, model, "faces", paperFaces, faces);
        cell(table, model, "vertices", paperVertices, vertices);
        cell(table, model, "ms", paperMillis, millis);
    }

    private static void cell(PaperTable table, String model, String figure, double paper, double here) {
        table.row(model, figure, Figures.number(paper), Figures.number(here), Figures.ratio(here, paper));
    }

    /** Table 5: resolution after the same wait. */
    PaperTable fifth() throws IOException {
        PaperTable table = new PaperTable(
                "table5",
                "Table 5: resolution after the same wait",
                "The first round of a client of the viewers from the servlet, as `jsm fetch --rounds 1` has it, over "
                        + wire.described(links)
                        + ". The model of the paper's size is that of the other tables; *whole* is what it was brought"
                        + " down from: " + Figures.count(served.bunny().whole().faces()) + " faces. The paper's three"
                        + " figures come after 195, 761 and 2,143 ms; ours come after one and the same wait. Error is the"
                        + " mean distance to the original in % of the diagonal. Figures over the faster links are medians"
                        + " of the rounds of " + ROUNDS + " clients, those over the slowest are of one.",
                "The paper's bunny is 72 kB of text, ours an archive of "
                        + Figures.count(served.archive().bytes().length)
                        + " bytes, so that a wait shows more on the two slower links, and the whole model tells them"
                        + " apart where that of the paper's size comes whole over both; a round ends early when all"
                        + " has come, and lasts longer than the wait when the first mesh needs more.",
                List.of("model", "wait", "link", "figure", "paper", "here", "÷ paper"));
        List<URI> archives = served.bunny().isReduced()
                ? List.of(served.archive(wire), served.wholeArchive(wire))
                : List.of(served.archive(wire));
        progress.step("table5: warm up", 0);
        wire.open();
        for (int i = 0; i < 3; i++) for (URI archive : archives) Streams.round(archive, WAITS.get(0));
        for (int a = 0; a < archives.size(); a++) {
            for (int wait : WAITS) {
                for (int l = 0; l < links.size(); l++) {
                    progress.step("table5: " + links.get(l).name(), (double) l / links.size());
                    wire.shape(links.get(l));
                    double[] shown = shown(archives.get(a), wait, l + 1 < links.size() ? ROUNDS : 1);
                    String[] cells = {
                        a == 0 ? "paper's size" : "whole",
                        wait + " ms",
                        links.get(l).name()
                    };
                    boolean compared = a == 0;
                    row(table, cells, "waited, ms", compared ? TRANSMITTED[l][0] : Double.NaN, shown[0]);
                    row(table, cells, "faces", compared ? TRANSMITTED[l][1] : Double.NaN, shown[1]);
                    row(table, cells, "vertices", compared ? TRANSMITTED[l][2] : Double.NaN, shown[2]);
                    row(table, cells, "error, %", Double.NaN, shown[3]);
                }
            }
        }
        wire.open();
        return table;
    }

    /** Milliseconds, faces, vertices and error of rounds of new clients: the median of each. */
    private static double[] shown(URI archive, int wait, int rounds) throws IOException {
        double[][] figures = new double[4][rounds];
        for (int i = 0; i < rounds; i++) {
            Streams.Round round = Streams.round(archive, wait);
            figures[0][i] = round.report().waitMillis();
            figures[1][i] = round.report().faces();
            figures[2][i] = round.vertices();
            figures[3][i] = round.report().errorMean();
        }
        return Arrays.stream(figures).mapToDouble(Figures::median).toArray();
    }

    private static void row(PaperTable table, String[] cells, String figure, double paper, double here) {
        table.row(
                cells[0],
                cells[1],
                cells[2],
                figure,
                Figures.number(paper),
                figure.startsWith("error") ? String.format(java.util.Locale.ROOT, "%.4f", here) : Figures.number(here),
                Figures.ratio(here, paper));
    }
}
