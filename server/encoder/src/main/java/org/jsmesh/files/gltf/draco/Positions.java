package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedException;

/**
 * Quantized positions, which other attributes are predicted from.
 *
 * @param values x, y and z, in the order of the stream
 */
record Positions(ValueOrder order, int[] values) {
    /** Puts the position at a corner into {@code to}. */
    void get(int corner, long[] to) throws PackedException {
        int at = 3 * order.entry(corner);
        for (int i = 0; i < 3; i++) to[i] = values[at + i];
    }
}
