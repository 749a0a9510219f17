package org.jsmesh.session;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * A file that one at a time has locked, in this process and all others. On POSIX systems a process loses the lock of a
 * file as soon as it closes any channel to it, so what the process itself has locked must not even be opened.
 * Thread-safe.
 */
final class LockedFile implements AutoCloseable {
    private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

    private final FileChannel channel;
    private final Path real;

    private LockedFile(FileChannel channel, Path real) {
        this.channel = channel;
        this.real = real;
    }

    /** Locks a file of a folder, making it when it is missing; null when somebody else has locked it. */
    static LockedFile tryLock(Path folder, String name) throws IOException {
        Path real = folder.toRealPath().resolve(name);
        if (!HELD.add(real)) return null;
        LockedFile locked = null;
        try {
            FileChannel channel = FileChannel.open(real, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            try {
                if (channel.tryLock() != null) locked = new LockedFile(channel, real);
            } catch (OverlappingFileLockException e) {
                // By something else in this process.
            } finally {
                if (locked == null) channel.close();
            }
            return locked;
        } finally {
            if (locked == null) HELD.remove(real);
        }
    }

    @Override
    public synchronized void close() throws IOException {
        // Once: the second time somebody else may have it.
        if (!channel.isOpen()) return;
        try {
            channel.close();
        } finally {
            HELD.remove(real);
        }
    }
}
