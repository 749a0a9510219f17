package org.jsmesh.files;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.Future;
import java.util.regex.Pattern;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelFile;

/**
 * Encodes many model files, several at a time. A file that cannot be encoded fails alone. The archives depend on the
 * files and on the settings, not on the number of threads. Thread-safe.
 */
public final class FolderEncoder {
    /** How notes speak of what does not come back. */
    private static final Pattern LOSS = Pattern.compile("(?i)\\b(dropped|skipped|not kept|left out|not found)\\b");

    private final EncoderSettings settings;

    /** @param settings for every file; its threads are shared by all files */
    public FolderEncoder(EncoderSettings settings) {
        if (settings.threads() < 1) throw new IllegalArgumentException("threads: " + settings.threads());
        this.settings = settings;
    }

    /**
     * Reads, encodes and writes every file.
     *
     * @return a row per job, in the order of the jobs
     * @throws CancellationException when the listener cancels, after all threads have stopped
     * @throws InterruptedException when this thread is interrupted, which cancels as well
     */
    public List<EncodeResult> encode(List<EncodeJob> jobs, FolderEncodeListener listener) throws InterruptedException {
        int workers = Math.max(1, Math.min(settings.threads(), jobs.size()));
        MeshEncoder encoder = new MeshEncoder(
                settings.withThreads(Math.max(1, settings.threads() / workers)), ForkJoinPool.commonPool());
        ExecutorService pool = Executors.newFixedThreadPool(workers);
        try {
            Run run = new Run(encoder, listener);
            List<Future<EncodeResult>> futures = new ArrayList<>();
            for (EncodeJob job : jobs) futures.add(pool.submit(() -> run.encode(job)));
            return results(futures, run);
        } finally {
            pool.shutdown();
        }
    }

    private static List<EncodeResult> results(List<Future<EncodeResult>> futures, Run run) throws InterruptedException {
        List<EncodeResult> results = new ArrayList<>();
        CancellationException cancelled = null;
        InterruptedException interrupted = null;
        for (Future<EncodeResult> future : futures) {
            while (true) {
                try {
                    results.add(future.get());
                    break;
                } catch (InterruptedException e) {
                    interrupted = e;
                    run.stopped = true;
                } catch (ExecutionException e) {
                    if (e.getCause() instanceof Error error) throw error;
                    if (!(e.getCause() instanceof CancellationException)) throw new IllegalStateException(e.getCause());
                    cancelled = (CancellationException) e.getCause();
                    break;
                }
            }
        }
        if (interrupted != null) throw interrupted;
        if (cancelled != null) throw cancelled;
        return results;
    }

    /** The work on one list of jobs. */
    private static final class Run {
        private final MeshEncoder encoder;
        private final FolderEncodeListener listener;
        volatile boolean stopped;

        Run(MeshEncoder encoder, FolderEncodeListener listener) {
            this.encoder = encoder;
            this.listener = listener;
        }

        EncodeResult encode(EncodeJob job) {
            EncodeResult result = tryEncode(job);
            synchronized (this) {
                listener.finished(job, result);
            }
            return result;
        }

        private EncodeResult tryEncode(EncodeJob job) {
            long begin = System.nanoTime();
            try {
                ProgressListener progress = progress(job);
                OutputFiles.requireReplaceable(job.output());
                progress.step("read", 0);
                ModelFile model = ModelFiles.read(job.input());
                EncodedArchive archive = encoder.encode(model.mesh(), ModelPictures.of(model.mesh()), progress);
                progress.step("write", 0);
                AtomicFiles.write(job.output(), archive.bytes());
                return result(job, model, archive, seconds(begin));
            } catch (CancellationException e) {
                throw e;
            } catch (IOException | RuntimeException | OutOfMemoryError e) {
                // Whatever is wrong with one file, the others are to be written.
                return EncodeResult.failed(job, seconds(begin), Explanation.of(job.input(), e));
            }
        }

        private ProgressListener progress(EncodeJob job) {
            return new ProgressListener() {
                @Override
                public void progress(String stage, double fraction) {
                    synchronized (Run.this) {
                        listener.progress(job, stage, fraction);
                    }
                }

                @Override
                public boolean isCancelled() {
                    return stopped || listener.isCancelled();
                }
            };
        }

        private static EncodeResult result(EncodeJob job, ModelFile model, EncodedArchive archive, double seconds) {
            List<String> repaired = new ArrayList<>();
            List<String> dropped = new ArrayList<>();
            for (String note : model.notes()) (isLoss(note) ? dropped : repaired).add(note);
            for (String note : archive.notes()) (isLoss(note) ? dropped : repaired).add(note);
            BatchIndex batches = archive.header().batches();
            return new EncodeResult(
                    job.input().toString(),
                    job.output().toString(),
                    archive.header().faces(),
                    archive.header().vertices(),
                    batches.faces(0),
                    archive.bytes().length,
                    batches.size(),
                    seconds,
                    repaired,
                    dropped,
                    null);
        }

        private static boolean isLoss(String note) {
            return LOSS.matcher(note).find();
        }

        private static double seconds(long beginNanos) {
            return (System.nanoTime() - beginNanos) / 1e9;
        }
    }
}
