package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import org.jsmesh.files.Explanation;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * Carries out {@link Preparation}s: reading archives is kept apart from encoding, so that a long encoding delays no
 * archive that exists.
 */
final class Preparer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(Preparer.class.getName());

    private final ModelEncoder encoder;
    private final HeaderReader reader;
    private final ArchiveCache cache;
    private final ThreadPoolExecutor openers = threads("jsm-open", 2);
    private final ThreadPoolExecutor encoders;
    private final LongAdder done = new LongAdder();
    private final LongAdder failed = new LongAdder();

    /** @throws IOException when archives cannot be kept in the cache folder */
    Preparer(StoreSettings settings, ModelEncoder encoder, HeaderReader reader) throws IOException {
        this.encoder = encoder;
        this.reader = reader;
        cache = new ArchiveCache(settings.cache());
        cache.prepare();
        encoders = threads("jsm-encode", settings.encoders());
    }

    Preparation start(Preparation preparation) {
        run(openers, preparation, () -> open(preparation));
        return preparation;
    }

    private void open(Preparation preparation) throws IOException {
        ModelEntry entry = preparation.entry();
        if (entry.isArchive()) {
            preparation.archive().complete(Archive.open(entry.path(), reader));
            return;
        }
        // The times of companion files count, so a cache folder serves one machine.
        Path place = cache.place(
                entry.path(), encoder.settings() + " " + preparation.stamp().companions());
        if (!Files.exists(place) || !openKept(preparation, place)) {
            run(encoders, preparation, () -> encode(preparation, place));
        }
    }

    private boolean openKept(Preparation preparation, Path place) throws IOException {
        try {
            preparation.archive().complete(Archive.open(place, reader));
            return true;
        } catch (MalformedStreamException e) {
            LOG.log(
                    Level.WARNING,
                    "Encoding {0} again: the archive kept as {1} is damaged: {2}",
                    preparation.entry().path(),
                    place,
                    e.getMessage());
            return false;
        }
    }

    private void encode(Preparation preparation, Path place) throws IOException {
        boolean whole = false;
        try {
            encodeAndOpen(preparation, place);
            whole = true;
        } finally {
            (whole ? done : failed).increment();
        }
    }

    private void encodeAndOpen(Preparation preparation, Path place) throws IOException {
        preparation.step("reading", 0);
        Path model = preparation.entry().path();
        LOG.log(Level.INFO, "Encoding {0}", model);
        byte[] archive = encoder.encode(model, preparation);
        preparation.step("writing", 1);
        cache.write(place, archive);
        preparation.archive().complete(Archive.open(place, reader));
        LOG.log(Level.INFO, "Encoded {0}: {1} bytes", model, Integer.toString(archive.length));
    }

    private void run(ExecutorService threads, Preparation preparation, Work work) {
        try {
            threads.execute(() -> {
                try {
                    work.run();
                } catch (IOException | RuntimeException | OutOfMemoryError | StackOverflowError e) {
                    preparation.fail(explain(preparation.entry(), e));
                }
            });
        } catch (RejectedExecutionException e) {
            preparation.fail(stopping(e));
        }
    }

    private static ModelUnavailableException stopping(Throwable e) {
        return ModelUnavailableException.passing("the server is stopping", "try again later", e);
    }

    private ModelUnavailableException explain(ModelEntry entry, Throwable e) {
        if (e instanceof CancellationException) {
            if (encoders.isShutdown()) return stopping(e);
            String what = "the file of model '" + entry.id() + "' changed meanwhile";
            return ModelUnavailableException.passing(what, "ask again", e);
        }
        boolean isItsFault = e instanceof ModelFormatException
                || e instanceof MalformedStreamException
                || e instanceof IllegalArgumentException;
        if (!isItsFault) LOG.log(Level.ERROR, "Cannot prepare " + entry.path(), e);
        Explanation words = Explanation.of("model '" + entry.id() + "'", e, Explanation.Audience.SERVER);
        return new ModelUnavailableException(words.sentence(), words.remedy(), e);
    }

    int waiting() {
        return encoders.getQueue().size();
    }

    int running() {
        return encoders.getActiveCount();
    }

    long done() {
        return done.sum();
    }

    long failed() {
        return failed.sum();
    }

    private static ThreadPoolExecutor threads(String name, int count) {
        return new ThreadPoolExecutor(count, count, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            thread.setPriority(Thread.NORM_PRIORITY - 1);
            return thread;
        });
    }

    @Override
    public void close() {
        openers.shutdown();
        encoders.shutdown();
    }

    /** What a thread does for a preparation. */
    private interface Work {
        void run() throws IOException;
    }
}
