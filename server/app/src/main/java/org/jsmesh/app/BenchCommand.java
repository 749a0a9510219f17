package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.jsmesh.app.bench.Benchmark;
import org.jsmesh.app.bench.PictureMeter;
import org.jsmesh.app.bench.ShownByPrefix;
import org.jsmesh.app.bench.WholeEncode;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.ConsoleProgress;
import org.jsmesh.app.console.JsonReport;
import org.jsmesh.app.console.Output;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.Quality;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.flags.EncodeConverters;
import org.jsmesh.mesh.Mesh;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm bench}: encode and decode speed of one model. */
@Command(
        name = "bench",
        description =
                "Measures how fast one thread encodes and decodes a model: CPU time, warmed up, best of several runs; and the heap that it needs.",
        footer = {"", "Examples:", "  jsm bench bunny.ply --json", "  jsm bench scan.ply --whole --quality fast"})
final class BenchCommand implements Callable<Integer> {
    @Parameters(paramLabel = "IN", description = "A model file, or an archive, whose original is then measured.")
    private Path in;

    @Option(
            names = "--whole",
            description = {
                "Instead, encode a model file from reading to writing, as the command encode does: seconds of the clock and of all processors by stage,",
                "at first, as the process has just begun, and once more; then the heap at the peak, reading included."
            })
    private boolean whole;

    @Option(
            names = "--shown",
            description = {
                "Instead, tell what the first bytes of an archive show, and how far that is from the original: its surface in %% of the diagonal, its normals in degrees,",
                "its colours, the effect of its other images (normals, metal, roughness, occlusion, opacity), and the light that it throws back and sends out, in %% of white;",
                "and from which share of the bytes on the colours are off by less than 3%% of white."
            })
    private boolean shown;

    @Option(
            names = "--quality",
            paramLabel = "fast|default|best",
            converter = EncodeConverters.QualityName.class,
            description = "With --whole: as of the command encode.")
    private Quality quality = Quality.DEFAULT;

    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "With --whole: threads to use. Default: one per processor.")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Mixin
    private JsonReport json;

    @Mixin
    private Output output;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws CommandFailure {
        if (whole) return callWhole();
        if (shown) return callShown();
        Benchmark.Result result = measure();
        if (json.isWanted()) output.json(result);
        else print(result);
        return 0;
    }

    private int callWhole() throws CommandFailure {
        if (threads < 1)
            throw new ParameterException(spec.commandLine(), "--threads is " + threads + ", it must be at least 1");
        EncoderSettings settings = EncoderSettings.defaults()
                .withQuality(quality)
                .withThreads(threads)
                .withPoster(false);
        WholeEncode.Result result;
        try (ConsoleProgress progress = output.progress(in)) {
            result = new WholeEncode(in, settings).measure(progress);
        } catch (IOException | IllegalArgumentException e) {
            throw new CommandFailure(in, e);
        }
        if (json.isWanted()) output.json(result);
        else print(result);
        return 0;
    }

    private int callShown() throws CommandFailure {
        ShownByPrefix.Result shownFirst;
        ArchiveFile archive = ArchiveInput.readWhole(in);
        try (ConsoleProgress progress = output.progress(in)) {
            shownFirst = new ShownByPrefix(archive, progress).measure();
        } catch (IOException | IllegalArgumentException e) {
            throw new CommandFailure(in, e);
        }
        List<ShownByPrefix.Row> rows = shownFirst.rows();
        double mean = ShownByPrefix.meanPicture(rows);
        if (json.isWanted())
            output.json(Map.of("meanPicture", mean, "bytesOfColours", shownFirst.bytesOfColours(), "rows", rows));
        else print(shownFirst, archive.length());
        return 0;
    }

    private void print(ShownByPrefix.Result shownFirst, long length) {
        List<ShownByPrefix.Row> rows = shownFirst.rows();
        output.line("     bytes      %      faces  images  distance %  normal °  colour %  surface %  picture %");
        for (ShownByPrefix.Row r : rows) {
            PictureMeter.Difference d = r.difference();
            output.line(String.format(
                    Locale.ROOT,
                    "%10d  %5.1f  %9d  %6d  %10.5f  %8.3f  %8.3f  %9.3f  %9.3f",
                    r.bytes(),
                    100.0 * r.bytes() / length,
                    r.faces(),
                    r.images(),
                    d.distance(),
                    d.normal(),
                    d.colour(),
                    d.surface(),
                    d.picture()));
        }
        output.line(String.format(
                Locale.ROOT,
                "colours off by less than 3%% of white: after %d bytes, %.2f%%",
                shownFirst.bytesOfColours(),
                100.0 * shownFirst.bytesOfColours() / length));
        output.line(String.format(
                Locale.ROOT,
                "mean difference of the picture while it arrives: %.3f%%",
                ShownByPrefix.meanPicture(rows)));
    }

    private void print(WholeEncode.Result r) {
        output.line(String.format(
                Locale.ROOT,
                "%d faces, %d bytes, %d threads, heap %.1f MiB, %.0f bytes per face",
                r.faces(),
                r.bytes(),
                r.threads(),
                mebibytes(r.peakHeapBytes()),
                r.peakHeapBytesPerFace()));
        print("at first", r.first());
        print("again", r.again());
    }

    private void print(String when, WholeEncode.Run run) {
        output.line(
                String.format(Locale.ROOT, "%-12s %8.3f s, %.0f faces/s", when, run.seconds(), run.facesPerSecond()));
        for (WholeEncode.Stage stage : run.stages())
            output.line(String.format(
                    Locale.ROOT,
                    "  %-12s %6.3f s %8.3f s of processors",
                    stage.name(),
                    stage.seconds(),
                    stage.processorSeconds()));
    }

    private Benchmark.Result measure() throws CommandFailure {
        try (ConsoleProgress progress = output.progress(in)) {
            Mesh mesh = in.toString().endsWith(".jsm")
                    ? ArchiveInput.readWhole(in).original(progress)
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
