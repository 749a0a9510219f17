package org.jsmesh.session;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;

/**
 * The bytes of one archive as far as they have arrived, for whoever wants to decode an earlier resolution once more or
 * to keep the whole file. A session that is given one ({@link SessionOptions#withArrived}) puts every byte into it,
 * also those that come from its cache. Each session needs one of its own. Thread-safe.
 */
public final class ArrivedBytes {
    private static final int PART = 1 << 16;

    private final List<byte[]> parts = new ArrayList<>();
    private long length;

    /** Nothing has arrived. */
    public ArrivedBytes() {}

    /** {@return the number of bytes from the beginning of the archive} */
    public synchronized long length() {
        return length;
    }

    synchronized void append(byte[] array, int offset, int count) {
        int from = offset;
        int end = offset + count;
        while (from < end) {
            int at = (int) (length % PART);
            if (at == 0) parts.add(new byte[PART]);
            int fitting = Math.min(end - from, PART - at);
            System.arraycopy(array, from, parts.get(parts.size() - 1), at, fitting);
            from += fitting;
            length += fitting;
        }
    }

    /**
     * Copies bytes that have arrived.
     *
     * @param from offset in the archive, 0 to {@link #length}
     * @param into takes them from its beginning
     * @param most bytes wanted, at most the length of that array
     * @return how many were copied; fewer than wanted where no more have arrived
     */
    public synchronized int copy(long from, byte[] into, int most) {
        if (from < 0 || from > length) throw new IllegalArgumentException("byte " + from + " of " + length);
        int wanted = (int) Math.min(most, length - from);
        for (int done = 0; done < wanted; ) {
            int at = (int) ((from + done) % PART);
            int count = Math.min(wanted - done, PART - at);
            System.arraycopy(parts.get((int) ((from + done) / PART)), at, into, done, count);
            done += count;
        }
        return wanted;
    }

    /**
     * Writes what has arrived when this is called.
     *
     * @param out takes all of it; it is not closed
     * @throws IOException that it throws
     */
    public void writeTo(OutputStream out) throws IOException {
        byte[] part = new byte[PART];
        long all = length();
        for (long at = 0; at < all; ) {
            int count = copy(at, part, (int) Math.min(PART, all - at));
            out.write(part, 0, count);
            at += count;
        }
    }
}
