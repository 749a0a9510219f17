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
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.jsmesh.lock.LockedFile;

/** The folder of models that were sent and are not encoded yet, one folder for each. Thread-safe. */
final class Spool {
    private static final Logger LOG = System.getLogger(Spool.class.getName());

    private final Path folder;
    private final AtomicLong numbers = new AtomicLong(System.currentTimeMillis() * 1_000_000);

    private Spool(Path folder) {
        this.folder = folder;
    }

    static Spool in(Path uploads) throws IOException {
        return new Spool(Files.createDirectories(uploads.resolve(".spool")));
    }

    /** Two servers would encode each other's models, and remove what the other is receiving. */
    static LockedFile lock(Path uploads) throws IOException {
        LockedFile lock = LockedFile.tryLock(uploads.resolve(".lock"));
        if (lock != null) return lock;
        throw new FileSystemException(
                uploads.toString(), null, "another server takes models here. Give each a folder of its own");
    }

    static void unlock(LockedFile lock) {
        try {
            lock.close();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "Cannot unlock the folder of uploads", e);
        }
    }

    /** A place for one more. */
    Ticket ticket(String id, Sender sender) {
        return Ticket.of(folder, numbers.incrementAndGet(), id, sender);
    }

    /** Room on the disk of the folder. */
    long freeBytes() throws IOException {
        return Files.getFileStore(folder).getUsableSpace();
    }

    /** What an earlier server has left, in the order in which it came. */
    record Left(List<Ticket> whole, List<Resumable> unfinished) {}

    /** Removes what is neither whole nor can become so. */
    Left left() throws IOException {
        List<Path> left = new ArrayList<>();
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(folder)) {
            for (Path one : folders) left.add(one);
        }
        left.sort(Comparator.comparing(Path::getFileName));
        List<Ticket> whole = new ArrayList<>();
        List<Resumable> unfinished = new ArrayList<>();
        for (Path one : left) {
            Ticket ticket = Ticket.of(one);
            Resumable part = ticket == null || ticket.received() != null ? null : Resumable.of(ticket);
            if (part != null) unfinished.add(part);
            else if (ticket == null || ticket.received() == null) Ticket.delete(one);
            else whole.add(ticket);
        }
        return new Left(whole, unfinished);
    }

    static void delete(Ticket ticket) {
        try {
            ticket.delete();
        } catch (IOException | RuntimeException e) {
            LOG.log(Level.WARNING, "Cannot remove " + ticket.folder(), e);
        }
    }

    /** The server stops in good order, which is not the model's fault. */
    static void stay(Ticket ticket) {
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
}
