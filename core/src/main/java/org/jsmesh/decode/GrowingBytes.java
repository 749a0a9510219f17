package org.jsmesh.decode;

import java.util.Arrays;

/** Bytes that arrive in portions. */
final class GrowingBytes {
    private byte[] bytes = new byte[0];
    private int length;

    void take(byte[] from, int offset, int count) {
        if (length + count > bytes.length) bytes = Arrays.copyOf(bytes, Math.max(length + count, 2 * bytes.length));
        System.arraycopy(from, offset, bytes, length, count);
        length += count;
    }

    int length() {
        return length;
    }

    /** At least {@link #length} bytes; shared. */
    byte[] bytes() {
        return bytes;
    }
}
