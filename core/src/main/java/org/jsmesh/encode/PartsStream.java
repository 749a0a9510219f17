package org.jsmesh.encode;

import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Objects;

/** Reads parts one after the other, without copies of them. */
final class PartsStream extends InputStream {
    private final List<ByteBuffer> parts; // over arrays
    private int part;
    private int at; // in that part

    PartsStream(List<ByteBuffer> parts) {
        this.parts = parts;
    }

    /** How many bytes of the present part are left; 0 at the end alone. */
    private int left() {
        while (part < parts.size()) {
            int left = parts.get(part).remaining() - at;
            if (left > 0) return left;
            part++;
            at = 0;
        }
        return 0;
    }

    @Override
    public int read() {
        if (left() == 0) return -1;
        ByteBuffer from = parts.get(part);
        return from.get(from.position() + at++) & 0xff;
    }

    @Override
    public int read(byte[] into, int offset, int length) {
        Objects.checkFromIndexSize(offset, length, into.length);
        if (length == 0) return 0;
        int count = Math.min(left(), length);
        if (count == 0) return -1;
        ByteBuffer from = parts.get(part);
        System.arraycopy(from.array(), from.arrayOffset() + from.position() + at, into, offset, count);
        at += count;
        return count;
    }

    @Override
    public long skip(long count) {
        long skipped = 0;
        while (skipped < count && left() > 0) {
            int step = (int) Math.min(left(), count - skipped);
            at += step;
            skipped += step;
        }
        return skipped;
    }

    @Override
    public int available() {
        return left();
    }
}
