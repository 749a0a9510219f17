package org.jsmesh.decode;

import java.util.Arrays;
import org.jsmesh.mesh.Sizes;

/** Bytes that arrive in portions. */
final class GrowingBytes {
    private byte[] bytes = new byte[0];
    private int length;

    /** @return false when they do not fit into an array with those that there are; then nothing is taken */
    boolean take(byte[] from, int offset, int count) {
        if (count > Sizes.MOST - length) return false;
        if (length + count > bytes.length)
            bytes = Arrays.copyOf(bytes, (int) Math.max(length + count, Math.min(Sizes.MOST, 2L * bytes.length)));
        System.arraycopy(from, offset, bytes, length, count);
        length += count;
        return true;
    }

    int length() {
        return length;
    }

    /** At least {@link #length} bytes; shared. */
    byte[] bytes() {
        return bytes;
    }

    /** Gives away the bytes, as an array of their length, and has none then. */
    byte[] drain() {
        byte[] all = length == bytes.length ? bytes : Arrays.copyOf(bytes, length);
        bytes = new byte[0];
        length = 0;
        return all;
    }
}
