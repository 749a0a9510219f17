package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.Files;
import java.util.concurrent.CancellationException;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.memory.HeapShortageException;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.memory.MemoryAdmission.Admission;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.mesh.ProgressListener;

/** The work of a {@link FolderEncoder} on one list of jobs. */
final class FolderRun {
    private final EncoderSettings settings;
    private final MemoryAdmission memory;
    private final FolderEncodeListener listener;
    private int left; // jobs that are not done
    private volatile boolean stopped;

    FolderRun(EncoderSettings settings, MemoryAdmission memory, FolderEncodeListener listener, int jobs) {
        this.settings = settings;
        this.memory = memory;
        this.listener = listener;
        left = jobs;
    }

    void stop() {
        stopped = true;
    }

    EncodeResult encode(EncodeJob job) throws InterruptedException {
        EncodeResult result = tryEncode(job);
        synchronized (this) {
            left--;
            listener.finished(job, result);
        }
        return result;
    }

    private EncodeResult tryEncode(EncodeJob job) throws InterruptedException {
        long begin = System.nanoTime();
        try {
            Admission room = null;
            try {
                room = admit(estimate(job).bytes());
                return encode(job, room, begin);
            } catch (OutOfMemoryError e) {
                if (room != null && room.isAlone()) throw e;
            } finally {
                if (room != null) room.close();
            }
            // What ran beside it may have taken what it needed, even while its header was read.
            try (Admission all = admit(memory.capacity())) {
                if (room == null) estimate(job);
                return encode(job, all, begin);
            }
        } catch (CancellationException e) {
            throw e;
        } catch (IOException | RuntimeException | VirtualMachineError | LinkageError | AssertionError e) {
            // Whatever is wrong with one file, the others must be written.
            return EncodeResult.failed(
                    job, seconds(begin), Explanation.of(job.input(), e).toString());
        }
    }

    private EncodeResult encode(EncodeJob job, Admission room, long begin) throws IOException {
        ModelEncoding encoding = new ModelEncoding(settings.withThreads(threads(room)));
        EncodedArchive archive = encoding.writeChecked(job.input(), job.output(), progress(job));
        return EncodeResult.of(job, archive.header(), seconds(begin), archive.notes());
    }

    /** Those that come with its part of the memory, and no fewer than there are for each of those that are left. */
    private synchronized int threads(Admission room) {
        long byMemory = Math.round((double) settings.threads() * room.bytes() / memory.capacity());
        return (int) Math.max(1, Math.max(byMemory, settings.threads() / Math.max(1, left)));
    }

    private MemoryEstimate estimate(EncodeJob job) throws IOException {
        // What is no file is told when it is read.
        if (!Files.isRegularFile(job.input())) return new MemoryEstimate(0, 0, 0, 0);
        MemoryEstimate need = MemoryEstimate.of(job.input(), settings);
        HeapShortageException.check(need);
        String warning =
                HeapShortageException.warning(need, Runtime.getRuntime().maxMemory());
        if (warning != null) {
            synchronized (this) {
                listener.warned(job, warning);
            }
        }
        return need;
    }

    private Admission admit(long bytes) throws InterruptedException {
        Admission room = memory.admit(bytes, this::isStopped);
        if (room == null) throw new CancellationException("the encoding was cancelled");
        return room;
    }

    private boolean isStopped() {
        return stopped || listener.isCancelled();
    }

    private ProgressListener progress(EncodeJob job) {
        return new ProgressListener() {
            @Override
            public void progress(String stage, double fraction) {
                synchronized (FolderRun.this) {
                    listener.progress(job, stage, fraction);
                }
            }

            @Override
            public boolean isCancelled() {
                return isStopped();
            }
        };
    }

    private static double seconds(long beginNanos) {
        return (System.nanoTime() - beginNanos) / 1e9;
    }
}
