package org.jsmesh.files;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;

/**
 * Encodes many model files, several at a time. A file that cannot be encoded fails alone. The archives depend on the
 * files and on the settings, not on the number of threads. Thread-safe.
 */
public final class FolderEncoder {
    private final EncoderSettings settings;

    /** @param settings for every file; its threads are shared by all files */
    public FolderEncoder(EncoderSettings settings) {
        if (settings.threads() < 1) throw new IllegalArgumentException("threads: " + settings.threads());
        this.settings = settings;
    }

    /**
     * Reads, encodes and writes every file.
     *
     * @param jobs each with a place of its own
     * @param listener hears how far the work is and may stop it
     * @return a row per job, in the order of the jobs
     * @throws CancellationException when the listener cancels, after all threads have stopped
     * @throws InterruptedException when this thread is interrupted, which cancels as well
     */
    public List<EncodeResult> encode(List<EncodeJob> jobs, FolderEncodeListener listener) throws InterruptedException {
        int workers = Math.max(1, Math.min(settings.threads(), jobs.size()));
        ModelEncoding encoding = new ModelEncoding(settings.withThreads(Math.max(1, settings.threads() / workers)));
        ExecutorService pool = Executors.newFixedThreadPool(workers);
        try {
            Run run = new Run(encoding, listener);
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
        private final ModelEncoding encoding;
        private final FolderEncodeListener listener;
        volatile boolean stopped;

        Run(ModelEncoding encoding, FolderEncodeListener listener) {
            this.encoding = encoding;
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
                EncodedArchive archive = encoding.write(job.input(), job.output(), progress(job));
                return EncodeResult.of(job, archive.header(), seconds(begin), archive.notes());
            } catch (CancellationException e) {
                throw e;
            } catch (IOException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
                // Whatever is wrong with one file, the others must be written.
                String error = Explanation.of(job.input(), e).toString();
                return EncodeResult.failed(job, seconds(begin), error);
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

        private static double seconds(long beginNanos) {
            return (System.nanoTime() - beginNanos) / 1e9;
        }
    }
}
