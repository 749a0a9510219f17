package org.jsmesh.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Binary numbers of a file, one after the other: from memory, or from a window that moves on. */
final class BinaryBytes {
    private static final int ROOM = 1 << 18;

    private final ByteBuffer data; // over an array, for a whole file or with room for any row
    private long base; // place in the file of its first byte
    private final long end;
    private InputStream in; // null when the buffer has all that follows

    /** @param in gives what is behind the limit of the buffer, or is null */
    BinaryBytes(ByteBuffer data, long base, long end, InputStream in) {
        this.data = data;
        this.base = base;
        this.end = end;
        this.in = in;
    }

    /** The bytes of a file from a place on. */
    static BinaryBytes of(ByteSource source, long from, ByteOrder order) {
        if (source instanceof ByteSource.Held held) {
            ByteBuffer all = ByteBuffer.wrap(held.content()).order(order);
            return new BinaryBytes(all.position((int) Math.min(from, all.limit())), 0, source.length(), null);
        }
        try {
            ByteBuffer none = ByteBuffer.allocate(ROOM).limit(0).order(order);
            return new BinaryBytes(none, from, source.length(), source.from(from));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Where the next number is taken from, always the same buffer; its limit is not the end of the file. */
    ByteBuffer data() {
        return data;
    }

    /** Whether so many bytes, no more than a number or a row has, are left; they are in the buffer then. */
    boolean has(int bytes) {
        return data.remaining() >= bytes || fill(bytes);
    }

    private boolean fill(int bytes) {
        if (in == null) return false;
        base += data.position();
        data.compact();
        try {
            while (data.position() < bytes && data.hasRemaining()) {
                int count = in.read(data.array(), data.arrayOffset() + data.position(), data.remaining());
                if (count < 0) {
                    in.close();
                    in = null;
                    break;
                }
                data.position(data.position() + count);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        data.flip();
        return data.remaining() >= bytes;
    }

    /** The place in the file of the next byte. */
    long offset() {
        return base + data.position();
    }

    /** Bytes of the file that are not taken. */
    long remaining() {
        return end - offset();
    }

    /** Passes over bytes; false where there are fewer. */
    boolean skip(long bytes) {
        for (long left = bytes; left > 0; ) {
            if (!has(1)) return false;
            int count = (int) Math.min(left, data.remaining());
            data.position(data.position() + count);
            left -= count;
        }
        return true;
    }
}
