package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.jsmesh.files.Explanation;

/** The models of a folder, or of one file, by id, as the last look at it found them. Thread-safe. */
final class ModelFolder {
    private static final Logger LOG = System.getLogger(ModelFolder.class.getName());
    private static final long RESCAN_NANOS = 1_000_000_000L;

    private final Path source;
    private final SharedTask scan = new SharedTask(this::scan);
    private final Runnable changed;
    private volatile FolderScan found = FolderScan.none();
    private volatile long scannedNanos;

    /** Files whose names the log has been told of. */
    private final Set<String> told = ConcurrentHashMap.newKeySet();

    /**
     * @param changed is told after every look at the folder
     * @throws IOException when the folder or file does not exist
     */
    ModelFolder(Path source, Runnable changed) throws IOException {
        this.source = source;
        this.changed = changed;
        if (!Files.exists(source)) throw new NoSuchFileException(source.toString());
    }

    /** Looks for new and removed models. */
    void look() throws IOException {
        scan.run();
    }

    /** Looks again now, or, when the folder cannot be listed, at the next request for a model that is not known. */
    void lookOrLater() {
        try {
            look();
        } catch (IOException e) {
            scannedNanos = System.nanoTime() - RESCAN_NANOS;
        }
    }

    /** The models that the last look found, in order of their ids. */
    Collection<ModelEntry> entries() {
        return found.entries().values();
    }

    /** Whether a model has that very id. */
    boolean has(String id) {
        return found.entries().containsKey(id);
    }

    /** The model of that id, or of a further id that leads to it; null when the last look found none. */
    ModelEntry known(String id) {
        return found.find(id);
    }

    /** The same, after another look when the last one is more than a second old and found none. */
    ModelEntry find(String id) throws IOException {
        ModelEntry entry = known(id);
        if (entry == null && System.nanoTime() - scannedNanos > RESCAN_NANOS) {
            look();
            entry = known(id);
        }
        return entry;
    }

    /** The model of that file; null when the last look found none. */
    ModelEntry of(Path file) {
        for (ModelEntry entry : entries()) if (entry.path().equals(file)) return entry;
        return null;
    }

    /**
     * A file that keeps a model sent under that id from getting it: the file has the id, or a name that would give it.
     *
     * @param owned tells the files of models that were sent, which do not count
     */
    ModelEntry inTheWayOf(String id, Predicate<Path> owned) throws IOException {
        ModelEntry there = find(id);
        if (there != null && !owned.test(there.path())) return there;
        for (ModelEntry entry : entries()) {
            if (ModelEntry.idOf(entry.name()).equals(id) && !owned.test(entry.path())) return entry;
        }
        return null;
    }

    private void scan() throws IOException {
        FolderScan scanned = FolderScan.scan(source);
        for (FileSystemException e : scanned.skipped()) {
            // Once for each, though every look at the folder finds it again.
            if (told.add(e.getFile()))
                LOG.log(Level.WARNING, Explanation.of(null, e).toString());
        }
        found = scanned;
        scannedNanos = System.nanoTime();
        changed.run();
    }
}
