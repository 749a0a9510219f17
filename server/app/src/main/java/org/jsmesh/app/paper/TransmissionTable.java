package org.jsmesh.app.paper;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.app.paper.Downloads.Part;
import org.jsmesh.app.paper.Downloads.Taken;
import org.jsmesh.mesh.ProgressListener;

/** Table 3 of the paper: transmission at once, and patch by patch. */
final class TransmissionTable {
    /** Of the paper, for each link: original, simplified model, all patches at once, one patch at once. */
    private static final double[][] MILLIS = {
        {411, 45, 150, 206_558}, {982, 190, 761, 207_814}, {10_956, 2143, 6039, Double.NaN}
    };

    private static final double[] BYTES = {71_962, 13_644, 39_859, 121_459};
    private static final List<String> WHAT =
            List.of("original", "simplified model", "all patches at once", "one patch at once");

    /** What took less is done again, for a median. */
    private static final double SHORT_MILLIS = 1000;

    private static final int RUNS = 25;

    private final Served served;
    private final Wire wire;
    private final List<LinkKind> links;
    private final ProgressListener progress;
    private double originalMillis = Double.NaN; // at the slowest link

    TransmissionTable(Served served, Wire wire, List<LinkKind> links, ProgressListener progress) {
        this.served = served;
        this.wire = wire;
        this.links = links;
        this.progress = progress;
    }

    PaperTable measure() throws IOException {
        String slowest = links.get(links.size() - 1).name();
        PaperTable table = new PaperTable(
                "table3",
                "Table 3: transmission over links",
                "The bunny (" + served.bunny().source() + ") over "
                        + wire.described(links)
                        + ". Every cell is a new connection of HTTP/1.1; its time runs from the first request to the"
                        + " last byte, and what takes less than a second is the median of " + RUNS
                        + ". Text comes from a plain web"
                        + " server, the archive from the servlet. *One patch at once* is really one request after the"
                        + " other on one connection, also at " + slowest + ", where the paper has no figure: "
                        + Figures.count(served.patches())
                        + " files of text; and for the archive, whose patches are coded"
                        + " together and have no address of their own, the bytes after the base in "
                        + Figures.count(served.archivePatches(wire).size())
                        + " ranges. Bytes are those of bodies; *with"
                        + " heads* is what the servers sent at " + slowest + ", with the heads of the answers.",
                "At " + slowest
                        + " the link decides, so that times go with the bytes; on the fast links the paper's times are"
                        + " those of its machines and not of the link (72 kB in 411 ms are 1.4 Mbit/s), and so are"
                        + " ours of some milliseconds, so that their ratio compares machines and not formats; what the"
                        + " table was to prove holds: one patch per request takes many times as long as all at once,"
                        + " and with heads many times the bytes, because of the round trips and the heads, of which an"
                        + " answer of the servlet has more (hash, caching, permissions).",
                List.of("link", "what", "paper", "text, gzip", "text ÷ paper", "jSM", "jSM ÷ paper"));
        List<List<Part>> text = List.of(
                List.of(Served.text(wire, "original")),
                List.of(Served.text(wire, "base")),
                List.of(Served.text(wire, "patches")),
                served.textPatches(wire));
        long base = served.archive().baseBytes();
        long end = served.archive().bytes().length;
        List<List<Part>> archive = List.of(
                List.of(Part.whole(served.archive(wire))),
                List.of(Part.of(served.archive(wire), 0, base)),
                List.of(Part.of(served.archive(wire), base, end)),
                served.archivePatches(wire));
        warmUp(text, archive);
        List<List<String>> sizes = new ArrayList<>();
        for (int l = 0; l < links.size(); l++) {
            wire.shape(links.get(l));
            sizes.clear();
            for (int w = 0; w < WHAT.size(); w++) {
                String stage = "table3: " + links.get(l).name() + ", " + WHAT.get(w);
                long before = wire.carriedBytes();
                Taken ofText = fetch(text.get(w), stage);
                long textCarried = wire.carriedBytes() - before;
                before = wire.carriedBytes();
                Taken ofArchive = fetch(archive.get(w), stage);
                long carried = wire.carriedBytes() - before;
                row(
                        table,
                        links.get(l).name(),
                        WHAT.get(w) + ", ms",
                        MILLIS[l][w],
                        ofText.millis(),
                        ofArchive.millis());
                if (w == 0) originalMillis = ofText.millis();
                sizes.add(cells("any", WHAT.get(w) + ", bytes", BYTES[w], ofText.bytes(), ofArchive.bytes()));
                if (w == WHAT.size() - 1)
                    sizes.add(cells("any", WHAT.get(w) + ", bytes with heads", Double.NaN, textCarried, carried));
            }
        }
        wire.open();
        table.rows().addAll(sizes);
        return table;
    }

    /** How long the original takes as text over the slowest link: as the table has it, or measured now. */
    double originalMillis() throws IOException {
        if (Double.isNaN(originalMillis)) {
            wire.shape(links.get(links.size() - 1));
            originalMillis =
                    fetch(List.of(Served.text(wire, "original")), "original").millis();
        }
        return originalMillis;
    }

    /** Connections, compiled code and caches of the servers are there once all was fetched. */
    private void warmUp(List<List<Part>> text, List<List<Part>> archive) throws IOException {
        wire.open();
        for (int i = 0; i < 2; i++) {
            for (List<Part> parts : text) Downloads.fetch(parts, x -> progress.step("table3: warm up", x));
            for (List<Part> parts : archive) Downloads.fetch(parts, x -> progress.step("table3: warm up", x));
        }
    }

    private Taken fetch(List<Part> parts, String stage) throws IOException {
        Taken first = Downloads.fetch(parts, x -> progress.step(stage, x));
        if (first.millis() >= SHORT_MILLIS || parts.size() > 1) return first;
        double[] millis = new double[RUNS];
        millis[0] = first.millis();
        for (int i = 1; i < RUNS; i++)
            millis[i] = Downloads.fetch(parts, x -> progress.step(stage, x)).millis();
        return new Taken(Figures.median(millis), first.bytes());
    }

    private static void row(PaperTable table, String link, String what, double paper, double text, double archive) {
        table.rows().add(cells(link, what, paper, text, archive));
    }

    private static List<String> cells(String link, String what, double paper, double text, double archive) {
        return List.of(
                link,
                what,
                Figures.number(paper),
                Figures.number(text),
                Figures.ratio(text, paper),
                Figures.number(archive),
                Figures.ratio(archive, paper));
    }
}
