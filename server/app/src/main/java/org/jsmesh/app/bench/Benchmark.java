package org.jsmesh.app.bench;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Map;
import java.util.TreeMap;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/**
 * Measures how fast one thread of this process encodes and decodes a mesh: CPU time after warming up, the best of
 * several runs. Peaks of the heap come from separate runs, because measuring them costs time.
 */
public final class Benchmark {
    private static final double WARM_UP_SECONDS = 2;
    private static final int RUNS = 5;
    private static final double MOST_SECONDS = 20;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Mesh mesh;
    private final ProgressListener progress;

    /**
     * The result; its names are those of {@code jsm bench --json}.
     *
     * @param encodeFacesPerSecond simplification and coding together
     * @param codingFacesPerSecond coding alone; 0 when the encoder does not report its stages
     * @param decodeFacesPerSecond without the identity hash
     * @param encodePeakHeapBytes most heap in use after collections while encoding, the mesh itself included
     */
    public record Result(
            int faces,
            long bytes,
            double encodeFacesPerSecond,
            double codingFacesPerSecond,
            double decodeFacesPerSecond,
            long encodePeakHeapBytes,
            long decodePeakHeapBytes) {}

    public Benchmark(Mesh mesh, ProgressListener progress) {
        this.mesh = mesh;
        this.progress = progress;
    }

    public Result run() throws IOException {
        MeshEncoder encoder = new MeshEncoder(EncoderSettings.defaults());
        Work encode = listener -> encoder.encode(mesh, listener);
        EncodedArchive archive = encoder.encode(mesh, ProgressListener.NONE);
        ArchiveFile file = ArchiveFile.of(archive.bytes());
        Work decode = listener -> file.meshAfter(file.batches() - 1, listener);
        Stages decoding = best("decode", decode); // decoding comes first, because clients never encode
        Stages encoding = best("encode", encode);
        progress.step("heap", 0);
        return new Result(
                mesh.faces(),
                archive.length(),
                perSecond(encoding.total()),
                perSecond(encoding.of("coding")),
                perSecond(decoding.total()),
                HeapPeak.of(() -> encode.run(ProgressListener.NONE)),
                HeapPeak.of(() -> decode.run(ProgressListener.NONE)));
    }

    private double perSecond(double nanos) {
        return nanos <= 0 ? 0 : Math.rint(mesh.faces() * 1e9 / nanos);
    }

    private Stages best(String what, Work work) throws IOException {
        long begin = System.nanoTime();
        do {
            progress.step(what + ": warm up", Math.min(1, (System.nanoTime() - begin) / 1e9 / WARM_UP_SECONDS));
            work.run(new Stages());
        } while (System.nanoTime() - begin < WARM_UP_SECONDS * 1e9);
        Stages best = null;
        begin = System.nanoTime();
        for (int i = 0; i < RUNS && (i == 0 || System.nanoTime() - begin < MOST_SECONDS * 1e9); i++) {
            progress.step(what, (double) i / RUNS);
            Stages run = new Stages();
            work.run(run);
            run.finish();
            if (best == null || run.total() < best.total()) best = run;
        }
        return best;
    }

    /** Something to measure. */
    private interface Work {
        public void run(ProgressListener listener) throws IOException;
    }

    /** CPU time of this thread by stage. */
    private static final class Stages implements ProgressListener {
        private final Map<String, Long> nanos = new TreeMap<>();
        private String stage = "";
        private long since = THREADS.getCurrentThreadCpuTime();

        @Override
        public void progress(String next, double fraction) {
            if (next.equals(stage)) return;
            finish();
            stage = next;
        }

        void finish() {
            long now = THREADS.getCurrentThreadCpuTime();
            nanos.merge(stage, now - since, Long::sum);
            since = now;
        }

        double total() {
            return nanos.values().stream().mapToLong(Long::longValue).sum();
        }

        double of(String name) {
            return nanos.getOrDefault(name, 0L);
        }
    }
}
