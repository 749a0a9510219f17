package org.jsmesh.app;

import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.jsmesh.encoder.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.session.RoundReport;
import org.jsmesh.session.SessionListener;
import org.jsmesh.session.SessionOptions;
import org.jsmesh.session.SessionProgress;
import org.jsmesh.session.SessionResult;
import org.jsmesh.session.StreamingSession;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm fetch}: a client without a window. */
@Command(
        name = "fetch",
        description = {
            "Streams a model: each round waits the same time and brings the detail that the bandwidth affords.",
            "Writes what it has after the last round; with --full the original, proved by its SHA-256."
        },
        footer = {"", "Example: jsm fetch http://localhost:8080/m/bunny/manifest.json -o bunny.ply --rounds 3"})
final class FetchCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Parameters(paramLabel = "URL", description = "Address of an archive or of a manifest.")
    private URI url;

    @Option(
            names = {"-o", "--output"},
            required = true,
            paramLabel = "OUT",
            description = "The model file to write; its extension chooses the format: ply, obj, stl, off, m or glb.")
    private Path out;

    @Option(
            names = "--wait",
            paramLabel = "T",
            defaultValue = "2s",
            description = "The wait per round. Default: ${DEFAULT-VALUE}.")
    private Wait wait;

    @ArgGroup
    private Extent extent = new Extent();

    @Option(
            names = "--server-plan",
            description = "Let the server turn bandwidth and wait into batches, the paper's way.")
    private boolean serverPlan;

    @Option(names = "--trace", paramLabel = "T.json", description = "Write a row per round and per request as JSON.")
    private Path trace;

    @Mixin
    private Output output;

    /** How far to go. */
    private static final class Extent {
        @Option(names = "--rounds", paramLabel = "N", description = "Rounds to go. Default: 1.")
        private int rounds = 1;

        @Option(names = "--full", description = "Fetch everything.")
        private boolean full;
    }

    @Override
    public Integer call() throws CommandFailure, InterruptedException {
        ModelFormat format = ModelFormat.ofName(out.toString());
        if (format == null)
            throw new ParameterException(
                    spec.commandLine(), "-o " + out + " has no known extension (ply, obj, stl, off, m, glb)");
        if (extent.rounds < 1)
            throw new ParameterException(
                    spec.commandLine(), "--rounds is " + extent.rounds + ", it must be at least 1");
        Mesh mesh;
        try (ConsoleProgress progress = output.progress("fetch")) {
            Heard heard = new Heard(progress);
            try (StreamingSession session = open(heard)) {
                mesh = stream(session, heard);
            }
        }
        try {
            for (String note : ModelFiles.write(mesh, out, format)) output.note(out + ": " + note);
        } catch (IOException e) {
            throw new CommandFailure(out, e);
        }
        return 0;
    }

    private StreamingSession open(SessionListener listener) {
        SessionOptions options =
                SessionOptions.defaults().withServerPlan(serverPlan).withMeshMillis(Integer.MAX_VALUE);
        try {
            return StreamingSession.open(url, options, listener, Runnable::run);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    private Mesh stream(StreamingSession session, Heard heard) throws CommandFailure, InterruptedException {
        try {
            if (extent.full) await(session.complete());
            for (int i = 0; !extent.full && i < extent.rounds && session.result() == null; i++)
                await(session.refine(wait.millis()));
        } finally {
            if (trace != null) writeTrace(session);
        }
        SessionResult result = session.result();
        if (result == null) return heard.mesh;
        if (!result.identical())
            throw new CommandFailure(
                    url + ": what arrived is not the original: " + result.difference() + ". Fetch it again.");
        output.line(out + ": the original, SHA-256 " + result.meshSha256());
        return result.mesh();
    }

    private void writeTrace(StreamingSession session) throws CommandFailure {
        try (OutputStream file = Files.newOutputStream(trace)) {
            session.trace().writeJson(file);
        } catch (IOException e) {
            throw new CommandFailure(trace, e);
        }
    }

    private static <T> T await(CompletableFuture<T> future) throws CommandFailure, InterruptedException {
        try {
            return future.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException io) throw new CommandFailure(null, io);
            if (e.getCause() instanceof RuntimeException unexpected) throw unexpected;
            throw new IllegalStateException(e.getCause());
        }
    }

    /** Keeps the mesh shown last and tells of rounds as they end. */
    private final class Heard implements SessionListener {
        private final ConsoleProgress progress;
        private volatile Mesh mesh;
        private int rounds;

        Heard(ConsoleProgress progress) {
            this.progress = progress;
        }

        @Override
        public void progressed(SessionProgress p) {
            progress.progress("receive", p.fraction());
        }

        @Override
        public void refined(Mesh refined, SessionProgress p) {
            mesh = refined;
        }

        @Override
        public void roundEnded(RoundReport r) {
            rounds++;
            output.line(String.format(
                    Locale.ROOT,
                    "round %d: %.2f s, %d bytes, %.1f kB/s, %d batches, %d faces, mean error %.5f%%",
                    rounds,
                    r.waitMillis() / 1000.0,
                    r.bytes(),
                    r.bytesPerSecond() / 1000.0,
                    r.batches(),
                    r.faces(),
                    r.errorMean()));
        }
    }
}
