package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jsmesh.encoder.ModelFiles;
import org.jsmesh.mesh.Mesh;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code jsm bench}: encode and decode speed of one model. */
@Command(
        name = "bench",
        description =
                "Measures how fast one thread encodes and decodes a model: CPU time, warmed up, best of several runs; and the heap that it needs.",
        footer = {"", "Example: jsm bench bunny.ply --json"})
final class BenchCommand implements Callable<Integer> {
    @Parameters(paramLabel = "IN", description = "A model file, or an archive, whose original is then measured.")
    private Path in;

    @Mixin
    private JsonReport json;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure {
        Benchmark.Result result = measure();
        if (json.isWanted()) output.json(result);
        else print(result);
        return 0;
    }

    private Benchmark.Result measure() throws CommandFailure {
        try (ConsoleProgress progress = output.progress(in)) {
            Mesh mesh = in.toString().endsWith(".jsm")
                    ? Archives.readWhole(in).original(progress)
                    : ModelFiles.read(in).mesh();
            return new Benchmark(mesh, progress).run();
        } catch (IOException | IllegalArgumentException e) {
            throw new CommandFailure(in, e);
        }
    }

    private void print(Benchmark.Result r) {
        output.line(String.format(Locale.ROOT, "%d faces, %d bytes", r.faces(), r.bytes()));
        output.line(String.format(
                Locale.ROOT,
                "encode %10.0f faces/s, coding alone %10.0f faces/s, heap %5.1f MiB",
                r.encodeFacesPerSecond(),
                r.codingFacesPerSecond(),
                mebibytes(r.encodePeakHeapBytes())));
        output.line(String.format(
                Locale.ROOT,
                "decode %10.0f faces/s, heap %5.1f MiB",
                r.decodeFacesPerSecond(),
                mebibytes(r.decodePeakHeapBytes())));
    }

    private static double mebibytes(long bytes) {
        return bytes / 1048576.0;
    }
}
