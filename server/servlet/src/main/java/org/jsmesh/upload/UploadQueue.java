package org.jsmesh.upload;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.Explanation;
import org.jsmesh.lock.LockedFile;
import org.jsmesh.mesh.Note;
import org.jsmesh.sandbox.EncodingFailure;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.sandbox.SandboxEncoder;

/**
 * Encodes models that were sent, one after the other. Everything that was accepted is in the spool folder until its
 * archive is in its place, so a server that starts again goes on where it stopped. Thread-safe.
 */
public final class UploadQueue implements AutoCloseable {
    private static final Logger LOG = System.getLogger(UploadQueue.class.getName());
    private static final int MOST_ATTEMPTS = 3;

    private final UploadSettings settings;
    private final Path folder;
    private final Spool spool;
    private final ModelEncoder encoder;
    private final Runnable changed;
    private final AtomicInteger length = new AtomicInteger();
    private final BlockingQueue<Ticket> waiting = new LinkedBlockingQueue<>();
    private final UploadStatuses statuses = new UploadStatuses();
    private final Keeping keeping;
    private final Resumables resumables;

    /** What is in the spool folder, whole. */
    private final Set<Ticket> accepted = ConcurrentHashMap.newKeySet();

    /** Of these the ones that shall not be encoded any more. */
    private final Set<Ticket> removed = ConcurrentHashMap.newKeySet();

    /** Held to give an archive its place, and to take it away. */
    private final Object turn = new Object();

    private final Thread worker = new Thread(this::work, "jsm-upload");
    private final LockedFile lock;
    private Ticket current;
    private volatile boolean closed;

    UploadQueue(UploadSettings settings, Path folder, ModelEncoder encoder, Runnable changed) throws IOException {
        this.settings = settings;
        this.folder = folder;
        this.encoder = encoder;
        this.changed = changed;
        spool = Spool.in(folder);
        lock = Spool.lock(folder);
        keeping = Keeping.open(folder.resolve(".senders"), this::place);
        resumables = new Resumables(settings, this, spool, keeping);
        goOn();
        worker.setDaemon(true);
        worker.setPriority(Thread.NORM_PRIORITY - 1);
        worker.start();
    }

    /**
     * Takes up what an earlier server has left.
     *
     * @param settings what senders are granted
     * @param folder for the archives, each named by its model's id, and the spool
     * @param changed is told when there is a new archive, on the thread of the queue
     * @return the queue, which encodes already; to be closed by the caller
     * @throws IOException when nothing can be written there, or no process can be started
     */
    public static UploadQueue open(UploadSettings settings, Path folder, Runnable changed) throws IOException {
        return new UploadQueue(settings, folder, SandboxEncoder.of(settings.sandbox()), changed);
    }

    private void goOn() throws IOException {
        Spool.Left left = spool.left();
        for (Ticket ticket : left.whole()) {
            keeping.resume(ticket.sender().key(), ticket.id());
            take(ticket);
        }
        left.unfinished().forEach(resumables::goOn);
    }

    /** {@return what senders are granted} */
    public UploadSettings settings() {
        return settings;
    }

    /**
     * Tells the archives of models that were sent from other files of the store.
     *
     * @param file its path, below the store's folder as the store was given it
     * @return true when it lies in the folder of this queue
     */
    public boolean owns(Path file) {
        return file.startsWith(folder);
    }

    /**
     * {@return the place for the archive of the model that was sent under that id; the file is there once the model is
     * encoded}
     *
     * @param id of the model, lower-case letters, digits and hyphens
     */
    public Path place(String id) {
        return folder.resolve(id + ".jsm");
    }

    /** {@return the number of models that are received, wait or are encoded} */
    public int length() {
        return length.get();
    }

    /**
     * Begins to receive a model.
     *
     * @param sender whose model it is
     * @param id checked: lower-case letters, digits and hyphens
     * @param extension of the model file, or {@code zip}
     * @return the upload, to be closed by the caller; null when the queue is full or closed
     * @throws QuotaException when the server keeps no more for the sender
     */
    public Upload begin(Sender sender, String id, String extension) throws QuotaException {
        int before = length.getAndUpdate(now -> Math.max(now, Math.min(now + 1, settings.queued())));
        if (closed || before >= settings.queued()) return null;
        String refusal = keeping.refusal(sender, id);
        if (refusal != null) {
            length.decrementAndGet();
            throw new QuotaException(refusal);
        }
        return new Upload(this, spool.ticket(id, sender), extension, settings.mostBytes());
    }

    /** {@return the models that come in parts} */
    public Resumables resumables() {
        return resumables;
    }

    /** Takes a model that is whole, even if the queue is full. */
    void take(Ticket ticket) {
        length.incrementAndGet();
        accept(ticket);
    }

    void accept(Ticket ticket) {
        accepted.add(ticket);
        statuses.begin(ticket);
        waiting.add(ticket);
    }

    void drop(Ticket ticket) {
        Spool.delete(ticket);
        accepted.remove(ticket);
        removed.remove(ticket);
        keeping.gone(ticket.sender().key(), ticket.id());
        length.decrementAndGet();
    }

    /**
     * Removes a model that was sent: its archive, and what waits or is being encoded under its id.
     *
     * @param id of the model
     * @return false when there was nothing
     * @throws IOException when the archive cannot be removed
     */
    public boolean remove(String id) throws IOException {
        List<Ticket> dropped = new ArrayList<>();
        boolean any;
        synchronized (turn) {
            any = Files.deleteIfExists(place(id));
            if (any) AtomicFiles.syncFolder(folder);
            keeping.forget(id);
            for (Ticket ticket : accepted) {
                if (!ticket.id().equals(id)) continue;
                any = true;
                if (waiting.remove(ticket)) dropped.add(ticket);
                else removed.add(ticket);
                if (ticket.equals(current)) worker.interrupt();
            }
        }
        dropped.forEach(this::drop);
        any |= statuses.forget(id);
        if (any) changed.run();
        return any;
    }

    /**
     * Tells the state of the model that was sent last under an id.
     *
     * @param id any text
     * @return its state; null when none was sent or taken up since the start, or at least 1000 others have changed
     *     their state since
     */
    public UploadStatus status(String id) {
        return statuses.of(id);
    }

    private void work() {
        while (!closed) {
            try {
                Ticket ticket = waiting.poll(1, TimeUnit.MINUTES);
                if (ticket == null) {
                    resumables.sweep();
                    continue;
                }
                UploadStatus status = begin(ticket) ? encode(ticket) : null;
                boolean gone = end(ticket);
                if (status == null && !gone) return;
                drop(ticket);
                if (gone) statuses.forget(ticket);
                else statuses.note(ticket, status);
            } catch (InterruptedException e) {
                // Closed, or told to give up what has just ended.
            }
        }
    }

    private boolean begin(Ticket ticket) {
        synchronized (turn) {
            current = ticket;
            return !removed.contains(ticket);
        }
    }

    /** Whether it was removed meanwhile. */
    private boolean end(Ticket ticket) {
        synchronized (turn) {
            current = null;
            return removed.contains(ticket);
        }
    }

    /** The outcome; null when the server stops, and the model stays for the next start. */
    private UploadStatus encode(Ticket ticket) {
        String id = ticket.id();
        try {
            statuses.note(ticket, UploadStatus.encoding(id, "starting", 0));
            if (ticket.attempt() > MOST_ATTEMPTS) {
                throw EncodingFailure.ofModel(
                        "the server broke down each of the " + MOST_ATTEMPTS + " times that it encoded the model",
                        "send a smaller model, or tell the server's owner");
            }
            LOG.log(Level.INFO, "Encoding the model {0} that was sent", id);
            encoder.encode(
                    ticket.received(),
                    ticket.archive(),
                    (stage, done) -> statuses.note(ticket, UploadStatus.encoding(id, stage, done)));
            List<Note> notes = ArchiveNotes.of(ticket.archive());
            publish(ticket);
            changed.run();
            return UploadStatus.ready(id, notes);
        } catch (EncodingFailure e) {
            LOG.log(Level.INFO, "The model {0} that was sent cannot be encoded: {1}", id, e.getMessage());
            return UploadStatus.failed(id, e.getMessage(), e.remedy());
        } catch (InterruptedException e) {
            if (closed) Spool.stay(ticket);
            return null;
        } catch (Throwable e) {
            // Whatever went wrong, the next model is not to blame.
            if (closed) Spool.stay(ticket);
            if (closed || removed.contains(ticket)) return null;
            LOG.log(Level.ERROR, "Cannot encode the model " + id + " that was sent", e);
            Explanation words = Explanation.of("the model", e, Explanation.Audience.SENDER);
            return UploadStatus.failed(id, words.sentence(), words.remedy());
        }
    }

    private void publish(Ticket ticket) throws IOException, EncodingFailure, InterruptedException {
        synchronized (turn) {
            if (removed.contains(ticket)) throw new InterruptedException();
            String refusal = keeping.refusal(ticket.sender(), ticket.id(), Files.size(ticket.archive()));
            if (refusal != null) throw EncodingFailure.ofModel(refusal, QuotaException.REMEDY);
            keeping.note(ticket.sender().key(), ticket.id());
            AtomicFiles.move(ticket.archive(), place(ticket.id()));
        }
    }

    /** Stops at once. The next start goes on with what is not encoded. */
    @Override
    public void close() {
        closed = true;
        worker.interrupt();
        try {
            worker.join(15_000);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        Spool.unlock(lock);
    }
}
