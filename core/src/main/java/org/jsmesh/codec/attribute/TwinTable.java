package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.mesh.KeyHash;

/**
 * Finds the last wedge with exact values in the same units of a channel. Where halves of a model share their part of an
 * image, it often has the very same values.
 */
final class TwinTable {
    private static final KeyHash HASH = KeyHash.OF_THIS_RUN;

    private final ChannelValues values;
    private final int shift;
    private final int[] slots; // wedges, or −1; open addressing

    TwinTable(ChannelValues values, int wedges) {
        this.values = values;
        shift = values.format.shift();
        slots = new int[2 << IntegerLog.bits(wedges)];
        Arrays.fill(slots, -1);
    }

    /** Returns the twin of a wedge, or −1, and puts the wedge in its place. */
    int replace(int wedge) {
        int hash = 0;
        for (int k = 0; k < values.components; k++) hash = HASH.of(hash, values.cell(wedge, k) >> shift);
        int mask = slots.length - 1;
        int slot = hash & mask;
        while (slots[slot] >= 0 && !isAlike(wedge, slots[slot])) slot = slot + 1 & mask;
        int twin = slots[slot];
        slots[slot] = wedge;
        return twin;
    }

    boolean isAlike(int a, int b) {
        for (int k = 0; k < values.components; k++)
            if (values.cell(a, k) >> shift != values.cell(b, k) >> shift) return false;
        return true;
    }
}
