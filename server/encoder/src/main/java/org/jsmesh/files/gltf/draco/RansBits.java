package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedBytes;
import org.jsmesh.files.gltf.packed.PackedException;

/** Bits of one probability, coded by an asymmetric numeral system (Draco specification, "rANS decoding"). */
final class RansBits {
    private static final int PRECISION = 256;
    private static final int BASE = 4096;

    private final byte[] bytes;
    private final int from;
    private final int probabilityOfOne;
    private int at;
    private int state;

    RansBits(PackedBytes in) throws PackedException {
        probabilityOfOne = PRECISION - in.next() & 0xFF;
        PackedBytes coded = in.takePart(in.count());
        bytes = coded.bytes;
        from = coded.position();
        int tail = RansSymbols.tailBytes(coded);
        if (tail > 3) throw new PackedException("the state of an entropy coder is damaged");
        at = coded.end() - tail;
        state = BASE + RansSymbols.tail(bytes, at, tail);
    }

    /** After the last byte the state goes on without new ones, as encoders expect. */
    boolean next() {
        if (state < BASE && at > from) state = state << 8 | bytes[--at] & 0xFF;
        int whole = (state >> 8) * probabilityOfOne;
        int rest = state & 0xFF;
        boolean one = rest < probabilityOfOne;
        state = one ? whole + rest : state - whole - probabilityOfOne;
        return one;
    }
}
