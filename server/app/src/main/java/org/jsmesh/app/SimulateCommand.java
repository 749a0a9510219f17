package org.jsmesh.app;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jsmesh.app.bench.Simulation;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.JsonReport;
import org.jsmesh.app.console.Output;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.simulation.HttpVersion;
import org.jsmesh.simulation.LinkTrace;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm simulate}: what a visitor with a given bandwidth sees. */
@Command(
        name = "simulate",
        description =
                "Shows what a visitor with a given bandwidth sees after each round, by the planner that the viewers use.",
        footer = {"", "Examples:", "  jsm simulate bunny.jsm --kbps 64", "  jsm simulate --compare"})
final class SimulateCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "IN.jsm", arity = "0..1", description = "The archive.")
    private Path in;

    @ArgGroup(multiplicity = "1")
    private Kind kind;

    /** The kind of the link, or the wish to see all of them. */
    private static final class Kind {
        @Option(names = "--kbps", paramLabel = "R", description = "Rate of the visitor's link in kbit/s.")
        private Double kbps;

        @Option(
                names = "--link",
                paramLabel = "NAME",
                description =
                        "A link of another kind: 64k, 256k, 1M, 10M, 100M, steps-10-1, steps-1-20, lognormal or lte.")
        private String link;

        @Option(
                names = "--compare",
                description = {
                    "Instead, compare this planner with others over all these links: 20 visitors with 6 rounds of 2 s each.",
                    "Without IN.jsm, of an archive that never ends."
                })
        private boolean compare;
    }

    @Option(names = "--http2", description = "A connection of HTTP/2. Default: HTTP/1.1.")
    private boolean http2;

    @Option(
            names = "--wait",
            paramLabel = "T",
            description = "The wait per round. Default: ${DEFAULT-VALUE}.",
            defaultValue = "2s")
    private Wait wait;

    @Option(
            names = "--round-trip",
            paramLabel = "T",
            description = "From a request to its first byte. Default: ${DEFAULT-VALUE}.",
            defaultValue = "50ms")
    private Wait roundTrip;

    @Option(
            names = "--rounds",
            paramLabel = "N",
            description = "Stop after N rounds. Default: when the original is there.")
    private int rounds = Integer.MAX_VALUE;

    @Option(
            names = "--pixels",
            paramLabel = "N",
            description =
                    "Stop when 99.9%% of the surface is no more than half a pixel off, the model's diagonal being N pixels long, and print the bytes that this takes.")
    private Integer pixels;

    @Mixin
    private JsonReport json;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        if (rounds < 1)
            throw new ParameterException(spec.commandLine(), "--rounds is " + rounds + ", it must be at least 1");
        if (pixels != null && pixels < 1)
            throw new ParameterException(spec.commandLine(), "--pixels is " + pixels + ", it must be at least 1");
        if (kind.compare) {
            PlannerTable.print(
                    in == null
                            ? PlannerTable.endless()
                            : ArchiveInput.read(in).header().batches(),
                    json,
                    output);
            return 0;
        }
        LinkTrace link = link();
        if (in == null) throw new ParameterException(spec.commandLine(), "name the archive IN.jsm");
        // The header is enough, because only the sizes of the batches are needed.
        ArchiveFile archive = ArchiveInput.read(in);
        HttpVersion version = http2 ? HttpVersion.HTTP_2 : HttpVersion.HTTP_1_1;
        List<Simulation.Row> rows = new Simulation(archive.header().batches(), link, version, roundTrip.millis())
                .run(wait.millis(), rounds, pixels == null ? -1 : HalfPixel.percent(pixels));
        HalfPixel half = pixels == null ? null : HalfPixel.of(archive.header().batches(), pixels);
        if (json.isWanted()) {
            Map<String, Object> report = new LinkedHashMap<>();
            report.put("rounds", rows);
            if (half != null) report.put("halfPixel", half);
            output.json(report);
            return 0;
        }
        print(rows, archive);
        if (half != null) output.line(half.line(archive.header().batches().archiveBytes()));
        return 0;
    }

    private LinkTrace link() {
        if (kind.kbps == null) {
            LinkTrace link = LinkTrace.named(kind.link);
            if (link != null) return link;
            String names = LinkTrace.all().stream().map(LinkTrace::name).collect(Collectors.joining(", "));
            throw new ParameterException(spec.commandLine(), "--link is " + kind.link + ", it must be one of " + names);
        }
        if (!(kind.kbps >= 1 && kind.kbps <= 1e9))
            throw new ParameterException(spec.commandLine(), "--kbps is " + kind.kbps + ", it must be 1 to 1000000000");
        return LinkTrace.constant("constant", 1000 * kind.kbps);
    }

    private void print(List<Simulation.Row> rows, ArchiveFile archive) {
        output.line(
                "round   wait s  requests       bytes      %  batches      faces  mean error %  99.9% below %  at most %");
        double total = archive.header().batches().archiveBytes();
        for (int i = 0; i < rows.size(); i++) {
            Simulation.Row r = rows.get(i);
            output.line(String.format(
                    Locale.ROOT,
                    "%5d  %7.2f  %8d  %10d  %5.1f  %7d  %9d  %12.5f  %13.5f  %9.4f",
                    i + 1,
                    r.waitMillis() / 1000,
                    r.requests(),
                    r.bytes(),
                    100 * r.bytes() / total,
                    r.batches(),
                    r.faces(),
                    r.errorMean(),
                    r.errorQuantile(),
                    r.errorBound()));
        }
    }
}
