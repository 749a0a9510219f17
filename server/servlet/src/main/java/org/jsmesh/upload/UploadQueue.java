package org.jsmesh.upload;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.Explanation;
import org.jsmesh.lock.LockedFile;
import org.jsmesh.mesh.Note;
import org.jsmesh.sandbox.EncodingFailure;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.sandbox.SandboxEncoder;
import org.jsmesh.sandbox.SandboxLimits;

/**
 * Encodes models that were sent, one after the other. Everything that was accepted is in the spool folder until its
 * archive is in its place, so a server that starts again goes on where it stopped. Thread-safe.
 */
public final class UploadQueue implements AutoCloseable {
    private static final Logger LOG = System.getLogger(UploadQueue.class.getName());
    private static final int MOST_STATUSES = 1000;
    private static final int MOST_ATTEMPTS = 3;

    private final UploadSettings settings;
    private final Path folder;
    private final Path spool;
    private final ModelEncoder encoder;
    private final Runnable changed;
    private final AtomicInteger length = new AtomicInteger();
    private final BlockingQueue<Ticket> waiting = new LinkedBlockingQueue<>();
    private final AtomicLong numbers = new AtomicLong(System.currentTimeMillis() * 1_000_000);
    private final Map<String, Noted> statuses = new LinkedHashMap<>();
    private final Thread worker = new Thread(this::work, "jsm-upload");
    private final LockedFile lock;
    private volatile boolean closed;

    UploadQueue(UploadSettings settings, Path folder, ModelEncoder encoder, Runnable changed) throws IOException {
        this.settings = settings;
        this.folder = folder;
        this.encoder = encoder;
        this.changed = changed;
        spool = folder.resolve(".spool");
        Files.createDirectories(spool);
        lock = lock(folder);
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
        return new UploadQueue(settings, folder, SandboxEncoder.of(sandbox(settings)), changed);
    }

    private static SandboxLimits sandbox(UploadSettings settings) {
        return SandboxLimits.defaults()
                .withHeapMegabytes(settings.heapMegabytes())
                .withEncodeMillis(settings.encodeMillis())
                .withMostFaces(settings.mostFaces())
                .withMostBytes(settings.mostBytes());
    }

    /** Two servers would encode each other's models, and remove what the other is receiving. */
    private static LockedFile lock(Path folder) throws IOException {
        LockedFile lock = LockedFile.tryLock(folder.resolve(".lock"));
        if (lock != null) return lock;
        throw new FileSystemException(
                folder.toString(), null, "another server takes models here. Give each a folder of its own");
    }

    private void goOn() throws IOException {
        List<Path> left = new ArrayList<>();
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(spool)) {
            for (Path one : folders) left.add(one);
        }
        left.sort(Comparator.comparing(Path::getFileName));
        for (Path one : left) {
            Ticket ticket = Ticket.of(one);
            if (ticket == null || ticket.received() == null) {
                Ticket.delete(one);
            } else {
                length.incrementAndGet();
                accept(ticket);
            }
        }
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
     * @param id checked: lower-case letters, digits and hyphens
     * @param extension of the model file, or {@code zip}
     * @return the upload, to be closed by the caller; null when the queue is full or closed
     */
    public Upload begin(String id, String extension) {
        int before = length.getAndUpdate(now -> Math.max(now, Math.min(now + 1, settings.queued())));
        if (closed || before >= settings.queued()) return null;
        return new Upload(this, Ticket.of(spool, numbers.incrementAndGet(), id), extension, settings.mostBytes());
    }

    void accept(Ticket ticket) {
        synchronized (statuses) {
            statuses.remove(ticket.id());
            note(ticket, UploadStatus.queued(ticket.id()));
            waiting.add(ticket);
        }
    }

    void drop(Ticket ticket) {
        try {
            ticket.delete();
        } catch (IOException | RuntimeException e) {
            LOG.log(Level.WARNING, "Cannot remove " + ticket.folder(), e);
        } finally {
            length.decrementAndGet();
        }
    }

    /**
     * Tells the state of the model that was sent last under an id.
     *
     * @param id any text
     * @return its state; null when none was sent or taken up since the start, or at least 1000 others have changed
     *     their state since
     */
    public UploadStatus status(String id) {
        synchronized (statuses) {
            Noted noted = statuses.get(id);
            return noted == null ? null : noted.status();
        }
    }

    private record Noted(Ticket ticket, UploadStatus status) {}

    /** Unless the model has come to its end, or was sent again meanwhile; then the status of the later one counts. */
    private void note(Ticket ticket, UploadStatus status) {
        synchronized (statuses) {
            Noted before = statuses.get(status.id());
            if (before != null
                    && (!before.ticket().equals(ticket) || before.status().isOver())) return;
            statuses.remove(status.id());
            statuses.put(status.id(), new Noted(ticket, status));
            if (statuses.size() > MOST_STATUSES)
                statuses.remove(statuses.keySet().iterator().next());
        }
    }

    private void work() {
        while (!closed) {
            Ticket ticket;
            try {
                ticket = waiting.take();
            } catch (InterruptedException e) {
                return;
            }
            UploadStatus status = encode(ticket);
            if (status == null) return;
            drop(ticket);
            note(ticket, status);
        }
    }

    /** The outcome; null when the server stops, and the model stays for the next start. */
    private UploadStatus encode(Ticket ticket) {
        String id = ticket.id();
        try {
            note(ticket, UploadStatus.encoding(id, "starting", 0));
            if (ticket.attempt() > MOST_ATTEMPTS) {
                throw EncodingFailure.ofModel(
                        "the server broke down each of the " + MOST_ATTEMPTS + " times that it encoded the model",
                        "send a smaller model, or tell the server's owner");
            }
            LOG.log(Level.INFO, "Encoding the model {0} that was sent", id);
            Path model = ticket.received();
            encoder.encode(
                    model, ticket.archive(), (stage, done) -> note(ticket, UploadStatus.encoding(id, stage, done)));
            List<Note> notes = ArchiveNotes.of(ticket.archive());
            AtomicFiles.move(ticket.archive(), place(id));
            changed.run();
            return UploadStatus.ready(id, notes);
        } catch (EncodingFailure e) {
            LOG.log(Level.INFO, "The model {0} that was sent cannot be encoded: {1}", id, e.getMessage());
            return UploadStatus.failed(id, e.getMessage(), e.remedy());
        } catch (InterruptedException e) {
            stay(ticket);
            return null;
        } catch (Throwable e) {
            // Whatever went wrong, the next model is not to blame.
            if (closed) {
                stay(ticket);
                return null;
            }
            LOG.log(Level.ERROR, "Cannot encode the model " + id + " that was sent", e);
            Explanation words = Explanation.of("the model", e, Explanation.Audience.SENDER);
            return UploadStatus.failed(id, words.sentence(), words.remedy());
        }
    }

    /** The server stops in good order, which is not the model's fault. */
    private static void stay(Ticket ticket) {
        // No file can be written while it is set.
        boolean interrupted = Thread.interrupted();
        try {
            ticket.takeBackAttempt();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "Cannot write in " + ticket.folder(), e);
        } finally {
            if (interrupted) Thread.currentThread().interrupt();
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
        try {
            lock.close();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "Cannot unlock " + folder, e);
        }
    }
}
