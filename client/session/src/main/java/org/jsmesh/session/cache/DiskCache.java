package org.jsmesh.session.cache;

import java.io.IOException;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import org.jsmesh.lock.LockedFile;

/**
 * A folder with the first bytes of archives, as far as they have come, for later sessions. Its size is bounded:
 * archives that were not used for longest go first. Several processes may use it: one at a time writes an entry, and
 * others may read it meanwhile. It may be emptied at any time.
 */
public final class DiskCache {
    private static final String LOG = ".log";

    private final Path folder;
    private final long mostBytes;

    /** @param folder made when it is first used */
    public DiskCache(Path folder, long mostBytes) {
        this.folder = folder;
        this.mostBytes = mostBytes;
    }

    /**
     * The kept bytes of an archive, and the place for more.
     *
     * @param archive its address; another host's claim to have the same archive is not trusted
     * @param sha256 of the archive
     * @throws IOException when the folder cannot be used
     */
    public KeptArchive open(URI archive, String sha256) throws IOException {
        String place = archive.getScheme() + "://" + archive.getRawAuthority() + archive.getRawPath();
        Path entry = folder.resolve(sha256 + "-" + hash(place));
        Files.createDirectories(folder);
        return exclusively(() -> {
            LockedFile lock = lock(entry);
            Path log = withEnd(entry, LOG);
            if (Files.exists(log)) Files.setLastModifiedTime(log, FileTime.fromMillis(System.currentTimeMillis()));
            evict();
            return new KeptArchive(this, withEnd(entry, ".jsm"), log, lock, mostBytes);
        });
    }

    private static String hash(String place) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256").digest(place.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(hash, 0, 8);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every JDK has SHA-256", e);
        }
    }

    private interface Work<T> {
        T run() throws IOException;
    }

    /** Only one process at a time takes and drops entries. */
    private <T> T exclusively(Work<T> work) throws IOException {
        // A lock of a file holds between processes, not within one.
        synchronized (DiskCache.class) {
            try (FileChannel all = FileChannel.open(
                            folder.resolve("cache.lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
                    FileLock lock = all.lock()) {
                assert lock.isValid();
                return work.run();
            }
        }
    }

    /** The entry for writing, or null when somebody else writes it. */
    private LockedFile lock(Path entry) throws IOException {
        return LockedFile.tryLock(withEnd(entry, ".lock"));
    }

    /** A session has ended. */
    void close(LockedFile lock) throws IOException {
        exclusively(() -> {
            lock.close();
            evict();
            return null;
        });
    }

    private record Entry(Path path, long bytes, FileTime used) {}

    private void evict() throws IOException {
        List<Entry> entries = new ArrayList<>();
        long sum = 0;
        try (DirectoryStream<Path> logs = Files.newDirectoryStream(folder, "*" + LOG)) {
            for (Path file : logs) {
                String name = String.valueOf(file.getFileName());
                Path path = folder.resolve(name.substring(0, name.length() - LOG.length()));
                Path data = withEnd(path, ".jsm");
                long bytes = Files.exists(data) ? Files.size(data) : 0;
                entries.add(new Entry(path, bytes, Files.getLastModifiedTime(file)));
                sum += bytes;
            }
        }
        entries.sort(Comparator.comparing(Entry::used));
        for (Entry entry : entries) {
            if (sum <= mostBytes) return;
            try (LockedFile lock = lock(entry.path())) {
                if (lock == null) continue;
                // In this order, because bytes without their log are useless.
                for (String end : new String[] {LOG, ".jsm", ".lock"}) Files.deleteIfExists(withEnd(entry.path(), end));
                sum -= entry.bytes();
            }
        }
    }

    private static Path withEnd(Path entry, String end) {
        return entry.resolveSibling(entry.getFileName() + end);
    }
}
