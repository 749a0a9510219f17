package org.jsmesh.session.cache;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.zip.CRC32;
import org.jsmesh.lock.LockedFile;

/**
 * The first bytes of one archive in a {@link DiskCache}: a file of the bytes, and a log with the length and CRC-32 of
 * each part, 4 bytes each. The log's row is written after its part. So a process that is killed loses nothing that it
 * has written, and damage costs only the parts from there on. When the disk fails, nothing more is kept, and the
 * session goes on.
 */
public final class KeptArchive implements AutoCloseable {
    private static final int PART_BYTES = 1 << 16;
    private static final int ROW_BYTES = 8;

    private final DiskCache cache;
    private final Path data;
    private final Path log;
    private final long mostBytes;
    private LockedFile lock;
    private FileChannel dataOut;
    private FileChannel logOut;
    private boolean writing;
    private long bytes;
    private long rows;

    /** @param lock of the entry, or null for reading only */
    KeptArchive(DiskCache cache, Path data, Path log, LockedFile lock, long mostBytes) {
        this.cache = cache;
        this.data = data;
        this.log = log;
        this.lock = lock;
        this.mostBytes = mostBytes;
        writing = lock != null;
    }

    /** Takes a part of what is kept. */
    public interface Taker {
        void take(byte[] array, int length) throws IOException;
    }

    /**
     * Gives the kept bytes to a taker, in order, once, up to the first damage.
     *
     * @throws IOException when the taker throws it
     */
    public void restore(Taker taker) throws IOException {
        try (InputStream parts = open(data);
                InputStream log = open(this.log)) {
            byte[] part = new byte[PART_BYTES];
            while (true) {
                ByteBuffer row = ByteBuffer.wrap(log.readNBytes(ROW_BYTES));
                if (row.remaining() < ROW_BYTES) return;
                int length = row.getInt();
                if (length < 1 || length > part.length || parts.readNBytes(part, 0, length) < length) return;
                if (crc(part, 0, length) != row.getInt()) return;
                rows++;
                bytes += length;
                taker.take(part, length);
            }
        }
    }

    private static InputStream open(Path file) {
        try {
            return Channels.newInputStream(FileChannel.open(file, StandardOpenOption.READ));
        } catch (IOException e) {
            return InputStream.nullInputStream();
        }
    }

    private static int crc(byte[] array, int offset, int length) {
        CRC32 crc = new CRC32();
        crc.update(array, offset, length);
        return (int) crc.getValue();
    }

    /** Keeps the bytes that come next. */
    public void append(byte[] array, int offset, int length) {
        for (int at = offset; at < offset + length && writing; at += PART_BYTES) {
            int count = Math.min(PART_BYTES, offset + length - at);
            if (bytes + count > mostBytes) {
                stop();
                return;
            }
            try {
                write(array, at, count);
            } catch (IOException e) {
                stop();
            }
        }
    }

    private void write(byte[] array, int offset, int length) throws IOException {
        if (dataOut == null) {
            dataOut = end(data, bytes);
            logOut = end(log, rows * ROW_BYTES);
        }
        write(dataOut, ByteBuffer.wrap(array, offset, length));
        ByteBuffer row = ByteBuffer.allocate(ROW_BYTES);
        write(logOut, row.putInt(length).putInt(crc(array, offset, length)).flip());
        bytes += length;
        rows++;
    }

    /** All that lies behind this place is damaged or does not count. */
    private static FileChannel end(Path file, long place) throws IOException {
        FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        channel.truncate(place);
        channel.position(place);
        return channel;
    }

    private static void write(FileChannel out, ByteBuffer rest) throws IOException {
        while (rest.hasRemaining()) out.write(rest);
    }

    /** Drops what is kept, because something about it is wrong; what comes is not kept any more. */
    public void forget() {
        stop();
        if (lock == null) return;
        try {
            Files.deleteIfExists(log);
            Files.deleteIfExists(data);
        } catch (IOException e) {
            // The next session will find the damage again.
        }
    }

    private void stop() {
        writing = false;
        try {
            if (dataOut != null) dataOut.close();
            if (logOut != null) logOut.close();
        } catch (IOException e) {
            // Each row counts alone.
        }
    }

    @Override
    public void close() {
        stop();
        LockedFile held = lock;
        lock = null;
        try {
            if (held != null) cache.close(held);
        } catch (IOException e) {
            // The process that ends gives the lock back.
        }
    }
}
