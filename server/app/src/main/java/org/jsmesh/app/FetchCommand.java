package org.jsmesh.app;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.ConsoleProgress;
import org.jsmesh.app.console.Output;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.OutputFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.UpAxis;
import org.jsmesh.session.ArchiveChangedException;
import org.jsmesh.session.FetchException;
import org.jsmesh.session.RenewingSession;
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

    @Mixin
    private ModelOutput out;

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

    @Option(names = "--http1", description = "Use HTTP/1.1 also where the server offers HTTP/2, as it can under TLS.")
    private boolean http1;

    @Option(
            names = "--cache",
            paramLabel = "DIR",
            description =
                    "Keep what arrives in this folder and ask for missing bytes alone; at most 1 GiB, those not used for longest go. Default: off.")
    private Path cache;

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
        Path local = local();
        out.check(local);
        if (trace != null && local != null && OutputFiles.areSame(trace, local))
            throw new ParameterException(
                    spec.commandLine(), "--trace " + trace + " is the archive itself, which would be lost");
        if (extent.rounds < 1)
            throw new ParameterException(
                    spec.commandLine(), "--rounds is " + extent.rounds + ", it must be at least 1");
        Heard heard;
        try (ConsoleProgress progress = output.progress("fetch")) {
            heard = new Heard(progress);
            try (RenewingSession session = open(heard)) {
                stream(session, heard);
            }
        }
        write(heard);
        return 0;
    }

    /** The file that a file address names, or null. */
    private Path local() {
        try {
            return "file".equals(url.getScheme()) ? Path.of(url) : null;
        } catch (IllegalArgumentException | FileSystemNotFoundException e) {
            return null; // opening it says what is wrong
        }
    }

    private void write(Heard heard) throws CommandFailure {
        SessionResult result = heard.result;
        Mesh mesh = result == null ? heard.mesh : result.mesh();
        UpAxis up = heard.header == null ? UpAxis.UNKNOWN : heard.header.up();
        List<String> losses = out.write(mesh, up, output);
        if (result != null) {
            output.line(out + ": " + out.original(losses, heard.header.provenance(), output)
                    + (losses.isEmpty() ? ", SHA-256 " + result.meshSha256() : ""));
            return;
        }
        for (String loss : losses) output.note(out + ": " + loss);
        out.noteMissing(mesh, heard.header.images(), output);
    }

    private RenewingSession open(Heard heard) {
        SessionOptions options = SessionOptions.defaults()
                .withServerPlan(serverPlan)
                .withHttp2(!http1)
                .withMeshMillis(Integer.MAX_VALUE)
                .withCache(cache);
        try {
            return new RenewingSession(
                    () -> StreamingSession.open(url, options, heard, Runnable::run), heard::renewed, Runnable::run);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    private void stream(RenewingSession session, Heard heard) throws CommandFailure, InterruptedException {
        try {
            if (extent.full) await(session.call(StreamingSession::complete));
            for (int i = 0;
                    !extent.full && i < extent.rounds && session.session().result() == null;
                    i++) await(session.call(s -> s.refine(wait.millis())));
        } finally {
            if (trace != null) writeTrace(session.session());
        }
        SessionResult result = session.session().result();
        heard.result = result;
        if (result != null && !result.identical())
            throw new CommandFailure(
                    url + ": what arrived is not the original: " + result.difference() + ". Fetch it again.");
    }

    private void writeTrace(StreamingSession session) throws CommandFailure {
        try {
            ByteArrayOutputStream json = new ByteArrayOutputStream();
            session.trace().writeJson(json);
            AtomicFiles.write(trace, json.toByteArray());
        } catch (IOException e) {
            throw new CommandFailure(trace, e);
        }
    }

    private <T> T await(CompletableFuture<T> future) throws CommandFailure, InterruptedException {
        try {
            return future.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException io) {
                boolean named = io instanceof FetchException || io instanceof ArchiveChangedException;
                throw new CommandFailure(named ? null : url, io);
            }
            if (e.getCause() instanceof RuntimeException unexpected) throw unexpected;
            if (e.getCause() instanceof Error error) throw error;
            throw new IllegalStateException(e.getCause());
        }
    }

    /** Keeps the mesh shown last and reports rounds as they end. */
    private final class Heard implements SessionListener {
        private final ConsoleProgress progress;
        private volatile Mesh mesh;
        private volatile ArchiveHeader header;
        private SessionResult result;
        private int rounds;

        Heard(ConsoleProgress progress) {
            this.progress = progress;
        }

        /** What has come is of an archive that is gone. */
        void renewed() {
            mesh = null;
            header = null;
            output.note(url + ": the archive was replaced meanwhile; the new one is fetched from its beginning.");
        }

        @Override
        public void preparing(String stage, double fraction) {
            progress.progress("server: " + stage, fraction);
        }

        @Override
        public void opened(ArchiveHeader opened) {
            header = opened;
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
