package org.jsmesh.store.cache;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.jsmesh.lock.LockedFile;

/**
 * A folder for what is not whole yet, for this store alone. What earlier stores left that were killed is removed. Those
 * that still run hold a lock.
 */
final class WorkFolder implements AutoCloseable {
    private static final String LOCK = "lock";

    private final Path folder;
    private final LockedFile lock;
    private final AtomicInteger numbers = new AtomicInteger();

    private WorkFolder(Path folder, LockedFile lock) {
        this.folder = folder;
        this.lock = lock;
    }

    /** @param all the folder that holds those of all stores */
    static WorkFolder open(Path all) throws IOException {
        Files.createDirectories(all);
        List<Path> others = new ArrayList<>();
        try (DirectoryStream<Path> folders = Files.newDirectoryStream(all)) {
            folders.forEach(others::add);
        }
        for (Path other : others) removeIfLeft(other);
        while (true) {
            Path folder = Files.createDirectories(all.resolve(UUID.randomUUID().toString()));
            LockedFile lock = LockedFile.tryLock(folder.resolve(LOCK));
            // Another store may have taken it for one that was left.
            if (lock != null && Files.isDirectory(folder)) return new WorkFolder(folder, lock);
            if (lock != null) lock.close();
        }
    }

    private static void removeIfLeft(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) return;
        LockedFile lock = LockedFile.tryLock(folder.resolve(LOCK));
        if (lock == null) return;
        try (lock) {
            remove(folder);
        }
    }

    private static void remove(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) Files.deleteIfExists(file);
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
    }

    /** A place for a file that nobody else writes. */
    Path next() throws IOException {
        // Somebody may have emptied the cache.
        Files.createDirectories(folder);
        return folder.resolve(numbers.incrementAndGet() + "." + ArchiveCache.ENDING);
    }

    @Override
    public void close() throws IOException {
        try (lock) {
            remove(folder);
        }
    }
}
