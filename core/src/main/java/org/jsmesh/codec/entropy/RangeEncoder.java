package org.jsmesh.codec.entropy;

import java.util.Arrays;
import org.jsmesh.mesh.Sizes;

/**
 * The writing side of a binary range coder with 31 bits of range and carry propagation (Martin 1979; the carry handling
 * is that of Subbotin and LZMA).
 */
public final class RangeEncoder extends BinaryCoder {
    private byte[] bytes = new byte[256];
    private int size;
    private long low;
    private int range = 0x7fffffff;
    private int cache = -1; // the byte that a carry may still change; -1 before the first
    private int pending; // bytes 0xff after it

    @Override
    public boolean isEncoder() {
        return true;
    }

    /** Bytes that {@link #finish} would give, within a few. */
    public int estimatedBytes() {
        return size + pending + 3;
    }

    @Override
    int codeBit(int probability, int bit) {
        int bound = (range >>> PROBABILITY_BITS) * probability;
        if (bit != 0) {
            range = bound;
        } else {
            low += bound;
            range -= bound;
        }
        normalise();
        return bit;
    }

    @Override
    int codeRaw(int value, int count) {
        range >>>= count;
        low += (long) range * value;
        normalise();
        return value;
    }

    @Override
    int codeBelow(int value, int bound) {
        range /= bound;
        low += (long) range * value;
        normalise();
        return value;
    }

    private void normalise() {
        while (range < 1 << 23) {
            range <<= 8;
            shift();
        }
    }

    private void shift() {
        int carry = (int) (low >>> 32);
        if (low < 0xff000000L || carry != 0) {
            if (cache >= 0) append(cache + carry);
            for (; pending > 0; pending--) append(0xff + carry);
            cache = (int) (low >>> 24) & 0xff;
        } else {
            pending++;
        }
        low = (low & 0xffffff) << 8;
    }

    private void append(int b) {
        if (size == bytes.length) bytes = Arrays.copyOf(bytes, Sizes.grown(size, "coded bytes of one kind"));
        bytes[size++] = (byte) b;
    }

    /**
     * The coded bytes without trailing zeros, which the decoder reads past the end. The coder cannot be used any more.
     */
    public byte[] finish() {
        for (int zeros = 24; zeros > 0; zeros -= 8) { // the roundest number in [low, low + range)
            long candidate = (low + (1L << zeros) - 1) >>> zeros << zeros;
            if (candidate < low + range) {
                low = candidate;
                break;
            }
        }
        int settled = size + pending;
        for (int i = 0; i < 5; i++) shift();
        while (size > settled && bytes[size - 1] == 0) size--;
        return Arrays.copyOf(bytes, size);
    }
}
