package org.jsmesh.mesh.io;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.jsmesh.mesh.Sizes;

/**
 * The bytes of a text file around a place in it. All bytes of a file in memory are there; of another file a window is,
 * which moves on. It holds what was asked for of the line at {@link #position}, however long; comments, and lines that
 * are passed over, go through it in portions.
 */
class ByteWindow {
    private static final int ROOM = 1 << 18;
    /** With fewer bytes left, the window moves on. Nearly all lines are shorter. */
    private static final int MARGIN = 1 << 12;

    private final long end; // of the file, or of what counts of it
    private long base; // place in the file of the first byte of the window
    private InputStream in; // null when the window has all that follows
    private int most = Integer.MAX_VALUE; // bytes that the window grows to

    byte[] bytes;
    int limit; // of the bytes that are there
    int position;

    /** All bytes of a file. */
    ByteWindow(byte[] all, int start) {
        bytes = all;
        limit = all.length;
        end = all.length;
        position = start == 0 ? afterByteOrderMark(all) : start;
    }

    /**
     * The bytes of a file from its start.
     *
     * @param end place of the first byte that does not count
     */
    ByteWindow(ByteSource source, long end) {
        this.end = end;
        if (source instanceof ByteSource.Held held) {
            bytes = held.content();
            limit = (int) end;
        } else {
            bytes = new byte[(int) Math.min(ROOM, Math.max(1, end))];
            try {
                in = source.from(0);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            has(MARGIN);
        }
        position = afterByteOrderMark(limit < bytes.length ? Arrays.copyOf(bytes, Math.min(3, limit)) : bytes);
    }

    static int afterByteOrderMark(byte[] bytes) {
        boolean marked =
                bytes.length >= 3 && bytes[0] == (byte) 0xEF && bytes[1] == (byte) 0xBB && bytes[2] == (byte) 0xBF;
        return marked ? 3 : 0;
    }

    /** The place in the file of the next byte. */
    long offset() {
        return base + position;
    }

    /** Goes to a place in the file a few bytes further. */
    void skipTo(long offset) {
        int target = (int) (offset - base);
        has(target - 1);
        position = Math.min(target, limit);
    }

    /** Bytes of the file behind the position. */
    long remaining() {
        return end - base - position;
    }

    /** Whether there is a byte at a place of the window, which may come to be there. */
    final boolean has(int at) {
        while (at >= limit) if (!more()) return false;
        return true;
    }

    /** Lets a line that is longer than so many bytes be as if the file ended in it, unless all is in memory. */
    void growTo(int bytesOfLine) {
        most = bytesOfLine;
    }

    /** Reads on behind the limit; every byte stays in its place. False at the end of the file. */
    final boolean more() {
        if (in == null || limit == bytes.length && limit >= most) return false;
        if (limit == bytes.length) bytes = Arrays.copyOf(bytes, Sizes.grown(limit, "bytes on a line"));
        try {
            int count = in.read(bytes, limit, (int) Math.min(bytes.length - limit, end - base - limit));
            if (count < 0 && base + limit < end) throw cut();
            if (count > 0) limit += count;
            else close();
            return count > 0;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Words for a source that ends before its length. */
    static EOFException cut() {
        return new EOFException("the file was cut while it was read. Try again when it is whole");
    }

    /** Reads what does not count, for those who count all bytes that are read. */
    private void close() throws IOException {
        byte[] rest = new byte[1 << 10];
        while (in.read(rest) >= 0) {}
        in.close();
        in = null;
    }

    /** Moves on where few bytes are left behind the position. Nothing before it is there then. */
    final void moveOn() {
        if (in != null && limit - position < MARGIN) drop();
    }

    /** Forgets all bytes before the position and reads on; false at the end of the file. */
    final boolean drop() {
        if (in == null) return false;
        int by = position;
        System.arraycopy(bytes, by, bytes, 0, limit - by);
        limit -= by;
        base += by;
        position = 0;
        moved(by);
        return more();
    }

    /** Places in the window are that much smaller now. */
    void moved(int by) {}

    /** What follows from a place a few bytes further on, as binary numbers. This window is of no use then. */
    BinaryBytes binaryFrom(long offset, ByteOrder order) {
        skipTo(offset);
        ByteBuffer data = ByteBuffer.wrap(bytes, 0, limit).position(position).order(order);
        BinaryBytes binary = new BinaryBytes(data, base, end, in);
        in = null;
        return binary;
    }
}
