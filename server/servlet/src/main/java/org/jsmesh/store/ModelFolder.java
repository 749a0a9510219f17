package org.jsmesh.store;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.ClosedWatchServiceException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import java.util.function.Predicate;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.PathNames;

/**
 * The models of a folder, or of one file, by id, kept up while files come, change and go. A thread of its own hears of
 * changes from the operating system, and looks itself now and then. Thread-safe.
 */
final class ModelFolder implements AutoCloseable {
    private static final Logger LOG = System.getLogger(ModelFolder.class.getName());

    /** Between two looks, however little they take. */
    private static final long BREATH_NANOS = 100_000_000L;

    private static final long ROUND_MILLIS = 1000;
    private static final long LONGEST_PAUSE_NANOS = 60_000_000_000L;
    /** Looking takes at most one part in so many of the time. */
    private static final int SHARE = 20;
    /** So many looks at folders come to one at all files. */
    private static final int FOLDER_LOOKS = 10;

    private final Path source;
    private final Path base;
    private final Runnable removed;
    private final FolderIndex index;
    private final Listing listing;
    private final FolderWatch watch;
    private final FolderScan scan;
    private final SharedTask all = new SharedTask(this::lookAtAll);
    private final Thread thread = new Thread(this::follow, "jsm-watch");

    /** Files whose names the log has been told of. */
    private final Set<String> told = ConcurrentHashMap.newKeySet();

    private volatile IOException failure;
    private volatile long nextLook;
    private volatile Object rootKey;
    private volatile boolean anyRemoved;
    private volatile boolean closed;

    /**
     * @param status tells the state of a model
     * @param removed is told after models were removed
     * @throws IOException when the folder or file does not exist
     */
    ModelFolder(Path source, Function<ModelEntry, ModelStatus> status, Runnable removed) throws IOException {
        this(existing(source), status, removed, FolderWatch.of(source));
    }

    ModelFolder(Path source, Function<ModelEntry, ModelStatus> status, Runnable removed, FolderWatch watch) {
        this.source = source;
        this.removed = removed;
        boolean isFile = Files.isRegularFile(source);
        base = isFile ? source.resolveSibling("") : source;
        listing = new Listing(status);
        index = new FolderIndex(base, this::changed);
        this.watch = watch;
        scan = new FolderScan(source, index, new Met());
        thread.setDaemon(true);
    }

    private static Path existing(Path source) throws IOException {
        if (!Files.exists(source)) throw new NoSuchFileException(source.toString());
        return source;
    }

    /** Looks at everything, and follows the changes from then on. */
    void open() throws IOException {
        look();
        thread.start();
    }

    /** Looks at every file: takes a while in a large folder. */
    void look() throws IOException {
        all.run();
    }

    /** Looks for new files in one folder of the folder. A failure shows in {@link #check}. */
    void lookInto(String place) {
        try {
            attempt(() -> scan.folder(place));
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "The folder of models cannot be listed", e);
        }
    }

    /** @throws IOException when the last look at the folder failed; this call looks at nothing */
    void check() throws IOException {
        IOException last = failure;
        if (last != null) throw new IOException(last.getMessage(), last);
    }

    /** All models, in order of their ids. */
    List<ModelEntry> entries() {
        return listing.all();
    }

    /** The models behind an id. */
    ModelPage page(String after) {
        return listing.page(after);
    }

    int size() {
        return listing.size();
    }

    /** The state of a model has changed. */
    void touched(String id) {
        listing.touched(id);
    }

    /** Whether a model has that very id. */
    boolean has(String id) {
        return index.get(id) != null;
    }

    /** The model of that id, or of a further id that leads to it; null when none is known. */
    ModelEntry known(String id) {
        return index.find(id);
    }

    /**
     * The same, after a look at folders that have changed when none is known. Such looks list no folder without need
     * and have breaks between them, so that they take a small part of the time however many unknown ids are asked for.
     */
    ModelEntry find(String id) throws IOException {
        ModelEntry entry = known(id);
        if (entry != null || !isTimeToLook()) return entry;
        lookAtFolders();
        return known(id);
    }

    /** The model of that file; null when none is known. */
    ModelEntry of(Path file) {
        return file.startsWith(base) || base.toString().isEmpty()
                ? index.at(PathNames.withSlashes(base.relativize(file)))
                : null;
    }

    /**
     * A file that keeps a model sent under that id from getting it: the file has the id, or a name that would give it.
     *
     * @param owned tells the files of models that were sent, which do not count
     */
    ModelEntry inTheWayOf(String id, Predicate<Path> owned) throws IOException {
        ModelEntry there = find(id);
        if (there != null && !owned.test(there.path())) return there;
        for (ModelEntry entry : index.named(id)) if (!owned.test(entry.path())) return entry;
        return null;
    }

    private void changed(String id, ModelEntry entry) {
        listing.changed(id, entry);
        if (entry == null) anyRemoved = true;
    }

    private void lookAtAll() throws IOException {
        attempt(() -> {
            watch.restart();
            rootKey = rootKey();
            timed(scan::all);
        });
    }

    /** Unless somebody else did meanwhile. */
    private void lookAtFolders() throws IOException {
        attempt(() -> {
            if (isTimeToLook()) timed(scan::changedFolders);
        });
    }

    /** What may fail when the folder cannot be read. */
    private interface Look {
        void run() throws IOException;
    }

    private void timed(Look look) throws IOException {
        long begin = System.nanoTime();
        try {
            look.run();
        } finally {
            long now = System.nanoTime();
            long pause = Math.min(LONGEST_PAUSE_NANOS, Math.max(BREATH_NANOS, SHARE * (now - begin)));
            nextLook = now + pause;
        }
    }

    private boolean isTimeToLook() {
        return System.nanoTime() - nextLook >= 0;
    }

    /** One look at a time. */
    private void attempt(Look look) throws IOException {
        synchronized (scan) {
            try {
                look.run();
                failure = null;
            } catch (IOException e) {
                failure = e;
                throw e;
            }
        }
        if (!anyRemoved) return;
        anyRemoved = false;
        removed.run();
    }

    private void follow() {
        long looked = System.nanoTime();
        int looks = 0;
        boolean isSure = true;
        while (!closed) {
            try {
                FolderWatch.Changes changes = watch.await(ROUND_MILLIS);
                if (!changes.places().isEmpty()) follow(changes.places());
                isSure &= changes.isSure() && failure == null && rootKey().equals(rootKey);
                boolean isTime = !watch.isWhole() || System.nanoTime() - looked > LONGEST_PAUSE_NANOS;
                if (isSure && !isTime || !isTimeToLook()) continue;
                looked = System.nanoTime();
                boolean isWhole = !isSure || ++looks % FOLDER_LOOKS == 0;
                isSure = true;
                if (isWhole) look();
                else lookAtFolders();
            } catch (IOException e) {
                report(e);
            } catch (InterruptedException | ClosedWatchServiceException e) {
                return;
            } catch (RuntimeException e) {
                LOG.log(Level.ERROR, "The folder of models cannot be followed", e);
            }
        }
    }

    private void follow(Set<String> places) throws IOException {
        attempt(() -> {
            for (String place : places) scan.at(place);
        });
    }

    /** Tells another folder of the same name from the one that was looked at; of a file, also whether it changed. */
    private Object rootKey() {
        try {
            BasicFileAttributes root = Files.readAttributes(source, BasicFileAttributes.class);
            Object key = String.valueOf(root.fileKey());
            return root.isDirectory() ? key : List.of(key, root.size(), root.lastModifiedTime());
        } catch (IOException e) {
            return "gone";
        }
    }

    /** Once for each reason, though every look meets it again. */
    private void report(IOException e) {
        if (told.add(String.valueOf(e.getMessage())))
            LOG.log(Level.WARNING, Explanation.of(source, e).toString());
    }

    /** Passes on what a look meets. */
    private final class Met implements FolderScan.Listener {
        @Override
        public void folder(String place, Path folder) {
            watch.add(place, folder);
        }

        @Override
        public void gone(String place) {
            watch.remove(place);
        }

        @Override
        public void skipped(FileSystemException reason) {
            if (told.add(reason.getFile()))
                LOG.log(Level.WARNING, Explanation.of(null, reason).toString());
        }
    }

    @Override
    public void close() {
        closed = true;
        watch.close();
        thread.interrupt();
    }
}
