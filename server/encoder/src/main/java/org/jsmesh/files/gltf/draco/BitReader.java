package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** Bits of Draco data, of each byte the lowest first. */
final class BitReader {
    private final byte[] bytes;
    private final int from;
    private final long end;
    private long at;

    /** Reads what {@code in} has left, and leaves it where it is. */
    BitReader(PackedBytes in) {
        bytes = in.bytes;
        from = in.position();
        end = 8L * in.remaining();
    }

    int next(int bits) throws PackedException {
        if (bits > end - at) throw new PackedException("the packed data ends too early");
        int value = 0;
        for (int i = 0; i < bits; i++, at++) {
            value |= (bytes[from + (int) (at >> 3)] >> (at & 7) & 1) << i;
        }
        return value;
    }

    /** How many bytes were begun. */
    int bytesRead() {
        return (int) ((at + 7) >> 3);
    }
}
