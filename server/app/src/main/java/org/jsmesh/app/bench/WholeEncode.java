package org.jsmesh.app.bench;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.ProgressListener;

/**
 * Encodes a model file from reading to writing, like {@code jsm encode}. Measures the time of each stage, by the clock
 * and by the processors.
 */
public final class WholeEncode {
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private final Path model;
    private final EncoderSettings settings;

    /**
     * A stage of the work; its times add up all parts with the same name.
     *
     * @param processorSeconds of the whole process, its compiler and collector included
     */
    public record Stage(String name, double seconds, double processorSeconds) {}

    /** A run; seconds are of the clock. */
    public record Run(double seconds, double facesPerSecond, List<Stage> stages) {}

    /** What {@link #measure} finds; its names are those of {@code jsm bench --whole --json}. */
    public record Result(
            int faces,
            long bytes,
            int threads,
            Run first,
            Run again,
            long peakHeapBytes,
            double peakHeapBytesPerFace) {}

    /** The outcome of an encoding. */
    private record Outcome(int faces, long bytes) {
        static Outcome of(EncodedArchive archive) {
            return new Outcome(archive.header().faces(), archive.length());
        }
    }

    public WholeEncode(Path model, EncoderSettings settings) {
        this.model = model;
        this.settings = settings;
    }

    /** Encodes three times: twice for the times, and once more for the peak of the heap. */
    public Result measure(ProgressListener progress) throws IOException {
        Run first = run(progress);
        Run again = run(progress);
        Outcome[] outcome = new Outcome[1];
        long peak = HeapPeak.of(() -> outcome[0] = Outcome.of(encode(progress)));
        int faces = outcome[0].faces;
        return new Result(
                faces, outcome[0].bytes, settings.threads(), first, again, peak, Math.rint((double) peak / faces));
    }

    private Run run(ProgressListener progress) throws IOException {
        Watch watch = new Watch(progress);
        int faces = encode(watch).header().faces();
        watch.progress("", 1);
        List<Stage> stages = new ArrayList<>();
        double seconds = 0;
        for (Map.Entry<String, double[]> stage : watch.stages.entrySet()) {
            double[] spent = stage.getValue();
            stages.add(new Stage(stage.getKey(), millis(spent[0]), millis(spent[1])));
            seconds += spent[0];
        }
        return new Run(millis(seconds), Math.rint(faces / seconds), stages);
    }

    private static double millis(double seconds) {
        return Math.rint(1000 * seconds) / 1000;
    }

    /** What {@code jsm encode} does with the model; the file is deleted again. */
    EncodedArchive encode(ProgressListener progress) throws IOException {
        Path folder = Files.createTempDirectory("jsm-bench");
        Path file = folder.resolve("model.jsm");
        try {
            return new ModelEncoding(settings).write(model, file, progress);
        } finally {
            Files.deleteIfExists(file);
            Files.delete(folder);
        }
    }

    /** Clock and processors, read whenever the stage changes. */
    private static final class Watch implements ProgressListener {
        private final ProgressListener shown;
        private final Map<String, double[]> stages = new LinkedHashMap<>();
        private String stage = "";
        private long since;
        private long processorsSince;

        Watch(ProgressListener shown) {
            this.shown = shown;
        }

        @Override
        public void progress(String next, double fraction) {
            if (!next.isEmpty()) shown.progress(next, fraction);
            if (next.equals(stage)) return;
            long now = System.nanoTime();
            long processors = SYSTEM.getProcessCpuTime();
            if (!stage.isEmpty()) {
                double[] spent = stages.computeIfAbsent(stage, name -> new double[2]);
                spent[0] += (now - since) / 1e9;
                spent[1] += (processors - processorsSince) / 1e9;
            }
            stage = next;
            since = now;
            processorsSince = processors;
        }

        @Override
        public boolean isCancelled() {
            return shown.isCancelled();
        }
    }
}
