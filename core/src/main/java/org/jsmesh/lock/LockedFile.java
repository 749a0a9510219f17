package org.jsmesh.lock;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * A file that only one user at a time can lock, in this process and all others. On POSIX systems a process loses the
 * lock of a file as soon as it closes any channel to it. So a file that the process itself has locked must not even be
 * opened. Thread-safe.
 */
public final class LockedFile implements AutoCloseable {
    /** Uses system properties, because web applications of one process share nothing else. */
    private static final String HELD = "org.jsmesh.locked.";

    private final FileChannel channel;
    private final String key;

    private LockedFile(FileChannel channel, String key) {
        this.channel = channel;
        this.key = key;
    }

    /**
     * Locks the file. Makes it when it is missing, and never deletes it.
     *
     * @param file in a folder that exists
     * @return null when somebody else has locked it
     * @throws IllegalArgumentException when the path is a root
     * @throws IOException when it cannot be written, or its folder is missing
     */
    public static LockedFile tryLock(Path file) throws IOException {
        Path absolute = file.toAbsolutePath().normalize();
        Path folder = absolute.getParent();
        if (folder == null) throw new IllegalArgumentException(file + " is a folder");
        String key = HELD + folder.toRealPath().resolve(absolute.getFileName());
        if (System.getProperties().putIfAbsent(key, "") != null) return null;
        LockedFile locked = null;
        try {
            FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            try {
                if (channel.tryLock() != null) locked = new LockedFile(channel, key);
            } catch (OverlappingFileLockException e) {
                // By something else in this process.
            } finally {
                if (locked == null) channel.close();
            }
            return locked;
        } finally {
            if (locked == null) System.getProperties().remove(key);
        }
    }

    @Override
    public synchronized void close() throws IOException {
        // Only once: the second time somebody else may have locked the file.
        if (!channel.isOpen()) return;
        try {
            channel.close();
        } finally {
            System.getProperties().remove(key);
        }
    }
}
