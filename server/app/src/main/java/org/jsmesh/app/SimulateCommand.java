package org.jsmesh.app;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jsmesh.encoder.ArchiveFile;
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
        footer = {"", "Example: jsm simulate bunny.jsm --kbps 64"})
final class SimulateCommand implements Callable<Integer> {
    private static final double HALF_A_PIXEL = 50; // in % of one

    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "IN.jsm", description = "The archive.")
    private Path in;

    @Option(names = "--kbps", required = true, paramLabel = "R", description = "Rate of the visitor's link in kbit/s.")
    private double kbps;

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
                    "Stop when no point is expected to be more than half a pixel off, the model's diagonal being N pixels long.")
    private Integer pixels;

    @Mixin
    private JsonReport json;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        if (!(kbps >= 1 && kbps <= 1e9))
            throw new ParameterException(spec.commandLine(), "--kbps is " + kbps + ", it must be 1 to 1000000000");
        if (rounds < 1)
            throw new ParameterException(spec.commandLine(), "--rounds is " + rounds + ", it must be at least 1");
        if (pixels != null && pixels < 1)
            throw new ParameterException(spec.commandLine(), "--pixels is " + pixels + ", it must be at least 1");
        // The header is enough: nothing of the batches is needed but their sizes.
        ArchiveFile archive = Archives.read(in);
        List<Simulation.Row> rows = new Simulation(archive.header().batches(), 1000 * kbps, roundTrip.millis())
                .run(wait.millis(), rounds, pixels == null ? -1 : HALF_A_PIXEL / pixels);
        if (json.isWanted()) output.json(Map.of("rounds", rows));
        else print(rows, archive);
        return 0;
    }

    private void print(List<Simulation.Row> rows, ArchiveFile archive) {
        output.line("round   wait s  requests       bytes      %  batches      faces  mean error %  at most %");
        double total = archive.header().batches().archiveBytes();
        for (int i = 0; i < rows.size(); i++) {
            Simulation.Row r = rows.get(i);
            output.line(String.format(
                    Locale.ROOT,
                    "%5d  %7.2f  %8d  %10d  %5.1f  %7d  %9d  %12.5f  %9.4f",
                    i + 1,
                    r.waitMillis() / 1000,
                    r.requests(),
                    r.bytes(),
                    100 * r.bytes() / total,
                    r.batches(),
                    r.faces(),
                    r.errorMean(),
                    r.errorBound()));
        }
    }
}
