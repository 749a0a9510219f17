package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.LongAdder;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.sandbox.EncodingFailure;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.store.cache.ArchiveCache;

/**
 * Carries out {@link Preparation}s: reading archives is kept apart from encoding, so that a long encoding delays no
 * archive that exists. Whatever goes wrong, a preparation comes to its end.
 */
final class Preparer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(Preparer.class.getName());
    private static final int OPENERS = 2;
    private static final long CLOSING_SECONDS = 20;

    private final ModelEncoder encoder;
    private final HeaderReader reader;
    private final ArchiveCache cache;
    private final ThreadPoolExecutor openers = threads("jsm-open", OPENERS);
    private final ThreadPoolExecutor encoders;
    private final LongAdder done = new LongAdder();
    private final LongAdder failed = new LongAdder();

    Preparer(StoreSettings settings, ModelEncoder encoder, HeaderReader reader, ArchiveCache cache) {
        this.encoder = encoder;
        this.reader = reader;
        this.cache = cache;
        encoders = threads("jsm-encode", settings.encoders());
        // An earlier server may have had a higher limit.
        openers.execute(cache::trim);
    }

    void start(Preparation preparation) {
        submit(openers, new Task(preparation, this::open));
    }

    /** Takes a preparation off the queue of encodings, if it is there. */
    void drop(Preparation preparation) {
        if (encoders.getQueue().removeIf(task -> ((Task) task).preparation == preparation))
            preparation.fail(forgotten());
    }

    private void open(Preparation preparation) throws IOException {
        ModelEntry entry = preparation.entry();
        if (entry.isArchive()) {
            preparation.complete(Archive.open(entry.path(), reader));
            return;
        }
        ArchiveCache.Kept kept = cache.find(entry.path(), encoder.settings());
        if (kept != null && openKept(preparation, kept)) return;
        preparation.progress("waiting", 0);
        submit(encoders, new Task(preparation, this::encode));
    }

    private boolean openKept(Preparation preparation, ArchiveCache.Kept kept) throws IOException {
        SourceStamp stamp = stamp(preparation, kept.inputs());
        // The files may have changed between their comparison and their stamp.
        if (!kept.inputs()
                .areFoundBy(ArchiveCache.companions(preparation.entry().path()))) return false;
        Archive archive = null;
        String fault;
        try {
            archive = Archive.open(kept.file(), reader);
            fault = archive.sha256().equals(kept.sha256()) ? null : "its bytes are not those that were written";
        } catch (NoSuchFileException e) {
            return false;
        } catch (MalformedStreamException e) {
            fault = e.getMessage();
        }
        if (fault == null) {
            cache.used(kept.file());
            finish(preparation, kept.inputs(), stamp, archive);
            return true;
        }
        if (archive != null) archive.close();
        LOG.log(
                Level.WARNING,
                "Encoding {0} again: the archive kept as {1} is damaged: {2}",
                preparation.entry().path(),
                kept.file(),
                fault);
        cache.drop(kept);
        return false;
    }

    /** The stamp of the model file as it was found, with that of its companions as they are now. */
    private static SourceStamp stamp(Preparation preparation, ModelInputs inputs) throws IOException {
        Path model = preparation.entry().path();
        return preparation.stamp().withWitnesses(inputs.witnesses(model));
    }

    private static void finish(Preparation preparation, ModelInputs inputs, SourceStamp stamp, Archive archive) {
        Set<Path> witnesses = inputs.witnesses(preparation.entry().path());
        preparation.witnessed(witnesses, stamp);
        preparation.complete(archive);
    }

    private void encode(Preparation preparation) throws IOException, InterruptedException {
        if (preparation.wish().isGone()) throw forgotten();
        boolean whole = false;
        Path file = null;
        try {
            preparation.step("reading", 0);
            Path model = preparation.entry().path();
            LOG.log(Level.INFO, "Encoding {0}", model);
            file = cache.begin(model);
            ModelInputs inputs = encoder.encode(model, file, preparation);
            preparation.step("writing", 1);
            SourceStamp stamp = stamp(preparation, inputs);
            boolean isStill = inputs.areFoundBy(ArchiveCache.companions(model));
            Archive archive = Archive.open(file, reader);
            try {
                cache.keep(file, archive.sha256(), inputs, encoder.settings());
            } catch (IOException e) {
                archive.close();
                throw EncodingFailure.noRoom(e);
            }
            for (Note note : archive.header().provenance().notes()) LOG.log(Level.INFO, "{0}: {1}", model, note.text());
            LOG.log(Level.INFO, "Encoded {0}: {1} bytes", model, Long.toString(archive.bytes()));
            // Companions that changed meanwhile make the next request look again.
            finish(preparation, inputs, isStill ? stamp : preparation.stamp().withoutTime(), archive);
            whole = true;
            cache.trim();
        } finally {
            (whole ? done : failed).increment();
            if (file != null) Files.deleteIfExists(file);
        }
    }

    private void submit(ThreadPoolExecutor threads, Task task) {
        try {
            threads.execute(task);
        } catch (RejectedExecutionException e) {
            task.preparation.fail(stopping(e));
        }
    }

    private static ModelUnavailableException stopping(Throwable e) {
        return ModelUnavailableException.passing("the server is stopping", "try again later", e);
    }

    private static ModelUnavailableException forgotten() {
        return ModelUnavailableException.passing("nobody waited for the encoding any more", "ask again", null);
    }

    private ModelUnavailableException explain(ModelEntry entry, Throwable e) {
        if (e instanceof ModelUnavailableException told) return told;
        if (e instanceof CancellationException || e instanceof InterruptedException) {
            if (encoders.isShutdown()) return stopping(e);
            String what = "the file of model '" + entry.id() + "' changed meanwhile";
            return ModelUnavailableException.passing(what, "ask again", e);
        }
        if (e instanceof NoSuchFileException && !Files.exists(entry.path()))
            return ModelUnavailableException.gone(entry.id(), e);
        String subject = "model '" + entry.id() + "'";
        if (e instanceof EncodingFailure failure) {
            if (failure.isPassing()) {
                LOG.log(Level.ERROR, "Cannot keep the archive of " + entry.path(), e);
                return ModelUnavailableException.passing(failure.getMessage(), failure.remedy(), e);
            }
            String reason = failure.getMessage().replaceFirst("^the model\\b", subject);
            LOG.log(Level.INFO, "Cannot encode {0}: {1}", entry.path(), reason);
            return ModelUnavailableException.ofModel(reason, failure.remedy(), e);
        }
        boolean isItsFault = e instanceof ModelFormatException
                || e instanceof MalformedStreamException
                || e instanceof IllegalArgumentException;
        if (!isItsFault) LOG.log(Level.ERROR, "Cannot prepare " + entry.path(), e);
        Explanation words = Explanation.of(subject, e, Explanation.Audience.SERVER);
        return ModelUnavailableException.ofModel(words.sentence(), words.remedy(), e);
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

    /** Takes nothing more. */
    void stop() {
        openers.shutdown();
        encoders.shutdown();
    }

    /** Waits for what was cancelled, then removes what it has left. */
    @Override
    public void close() {
        stop();
        try {
            encoders.awaitTermination(CLOSING_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        cache.close();
    }

    /** What is done for a preparation. */
    private interface Work {
        void run(Preparation preparation) throws IOException, InterruptedException;
    }

    /** Comes to an end for those who wait, whatever is thrown. */
    private final class Task implements Runnable {
        private final Preparation preparation;
        private final Work work;

        Task(Preparation preparation, Work work) {
            this.preparation = preparation;
            this.work = work;
        }

        @Override
        public void run() {
            try {
                work.run(preparation);
            } catch (Throwable e) {
                ModelUnavailableException reason;
                try {
                    reason = explain(preparation.entry(), e);
                } catch (Throwable again) {
                    reason = ModelUnavailableException.passing("the server failed", "try again later", null);
                }
                preparation.fail(reason);
            }
        }
    }
}
