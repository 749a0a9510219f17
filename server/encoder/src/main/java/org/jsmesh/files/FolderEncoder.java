package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.memory.MemoryAdmission;

/**
 * Encodes many model files, as many at a time as there are threads for and fit the heap; the largest begin first. A
 * file that cannot be encoded fails alone. The archives depend on the files and on the settings, not on the number of
 * threads nor on the heap. Thread-safe.
 */
public final class FolderEncoder {
    private final EncoderSettings settings;
    private final MemoryAdmission memory;

    /** @param settings for every file; its threads are shared by all files */
    public FolderEncoder(EncoderSettings settings) {
        this(settings, MemoryAdmission.ofHeap());
    }

    private FolderEncoder(EncoderSettings settings, MemoryAdmission memory) {
        if (settings.threads() < 1) throw new IllegalArgumentException("threads: " + settings.threads());
        this.settings = settings;
        this.memory = memory;
    }

    /**
     * Shares the heap with other work of this process.
     *
     * @param gate that each file has to pass
     * @return an encoder that differs in that alone
     */
    public FolderEncoder withMemory(MemoryAdmission gate) {
        return new FolderEncoder(settings, gate);
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
        ExecutorService pool = Executors.newFixedThreadPool(workers);
        try {
            FolderRun run = new FolderRun(settings, memory, listener, jobs.size());
            List<Future<EncodeResult>> futures = new ArrayList<>(
                    jobs.stream().map(job -> (Future<EncodeResult>) null).toList());
            for (int i : largestFirst(jobs)) futures.set(i, pool.submit(() -> run.encode(jobs.get(i))));
            return results(futures, run);
        } finally {
            pool.shutdown();
        }
    }

    private static List<Integer> largestFirst(List<EncodeJob> jobs) {
        long[] bytes = new long[jobs.size()];
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < bytes.length; i++) {
            order.add(i);
            try {
                bytes[i] = Files.size(jobs.get(i).input());
            } catch (IOException e) {
                bytes[i] = 0; // Reading it will fail, with better words.
            }
        }
        order.sort(Comparator.comparingLong(i -> -bytes[i]));
        return order;
    }

    private static List<EncodeResult> results(List<Future<EncodeResult>> futures, FolderRun run)
            throws InterruptedException {
        List<EncodeResult> results = new ArrayList<>();
        CancellationException cancelled = null;
        InterruptedException interrupted = null;
        Throwable broken = null;
        for (Future<EncodeResult> future : futures) {
            while (true) {
                try {
                    results.add(future.get());
                    break;
                } catch (InterruptedException e) {
                    interrupted = e;
                    run.stop();
                } catch (ExecutionException e) {
                    if (e.getCause() instanceof CancellationException c) {
                        cancelled = c;
                    } else {
                        broken = e.getCause();
                        run.stop();
                    }
                    break;
                }
            }
        }
        if (interrupted != null) throw interrupted;
        if (broken instanceof Error error) throw error;
        if (broken != null) throw new IllegalStateException(broken);
        if (cancelled != null) throw cancelled;
        return results;
    }
}
