package org.jsmesh.files.gltf.packed;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Turns differences into elements. Each four bytes of an element are a channel with a mode of its own: differences of
 * bytes, of 16-bit numbers, or rotated exclusive ors of 32 bits.
 */
final class ElementChannels {
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final int BYTES = 0;
    private static final int SHORTS = 1;
    private static final int ROTATED = 2;

    private final int[] last;
    private final int[] modes;
    private final byte[] values;
    private int at;

    /**
     * @param baseline the element before the first
     * @param modes of each channel; of no length when all are differences of bytes
     * @param values to be filled
     */
    ElementChannels(byte[] baseline, byte[] modes, byte[] values) throws PackedException {
        last = new int[baseline.length / 4];
        for (int c = 0; c < last.length; c++) last[c] = (int) INT.get(baseline, 4 * c);
        this.modes = new int[last.length];
        for (int c = 0; c < modes.length; c++) {
            int mode = modes[c] & 0xFF;
            if ((mode & 15) > ROTATED || (mode & 15) < ROTATED && mode > 15) {
                throw new PackedException("the channel mode " + mode + " is not known");
            }
            this.modes[c] = mode;
        }
        this.values = values;
    }

    byte[] values() {
        return values;
    }

    /** Appends elements from differences, of which each byte of an element has its own {@code distance} ones. */
    void append(byte[] differences, int distance, int count) {
        int stride = 4 * last.length;
        for (int c = 0; c < last.length; c++) {
            int previous = last[c];
            int mode = modes[c] & 15;
            int rotation = modes[c] >> 4;
            int from = 4 * c * distance;
            for (int i = 0; i < count; i++, from++) {
                int packed = differences[from] & 0xFF
                        | (differences[from + distance] & 0xFF) << 8
                        | (differences[from + 2 * distance] & 0xFF) << 16
                        | differences[from + 3 * distance] << 24;
                previous = switch (mode) {
                    case BYTES -> addBytes(previous, unzigzag(packed, 0x01010101, 0x7F7F7F7F));
                    case SHORTS -> addShorts(previous, unzigzag(packed, 0x00010001, 0x7FFF7FFF));
                    default -> previous ^ Integer.rotateRight(packed, rotation);
                };
                INT.set(values, at + i * stride + 4 * c, previous);
            }
            last[c] = previous;
        }
        at += count * stride;
    }

    /** Of several numbers in one int at once: 2n is n, 2n+1 is -n-1. {@code ones} has the lowest bit of each. */
    private static int unzigzag(int packed, int ones, int halves) {
        int signs = packed & ones;
        int mask = (ones == 0x01010101) ? signs * 0xFF : signs * 0xFFFF;
        return packed >>> 1 & halves ^ mask;
    }

    private static int addBytes(int a, int b) {
        return (a & 0x7F7F7F7F) + (b & 0x7F7F7F7F) ^ (a ^ b) & 0x80808080;
    }

    private static int addShorts(int a, int b) {
        return (a & 0x7FFF7FFF) + (b & 0x7FFF7FFF) ^ (a ^ b) & 0x80008000;
    }
}
