package org.jsmesh.mesh.io;

import java.util.Arrays;
import org.jsmesh.mesh.Sizes;
import org.jsmesh.mesh.TooLargeException;
import org.jsmesh.mesh.TupleHash;

/** Gives equal tuples of ints the same id; ids count up from 0 in the order of first sight. */
final class TupleIndex {
    private static final int MOST_SLOTS = 1 << 30;
    private static final String WHAT = "different vertices or attributes";

    private final int width;
    private final TupleHash hash;
    private int[] tuples;
    private int[] slots;
    private int size;

    /** @param width ints per tuple */
    TupleIndex(int width) {
        this.width = width;
        hash = new TupleHash(width);
        tuples = new int[64 * width];
        slots = new int[128];
        Arrays.fill(slots, -1);
    }

    int size() {
        return size;
    }

    /** Value {@code i} of a tuple. */
    int value(int id, int i) {
        return tuples[id * width + i];
    }

    /** All tuples, by id. */
    int[] toArray() {
        return Arrays.copyOf(tuples, size * width);
    }

    /** The id of the tuple that starts at an offset of an array. */
    int intern(int[] source, int offset) {
        int mask = slots.length - 1;
        int slot = hash.of(source, offset) & mask;
        while (slots[slot] >= 0) {
            if (matches(slots[slot], source, offset)) return slots[slot];
            slot = (slot + 1) & mask;
        }
        slots[slot] = size;
        if ((size + 1L) * width > tuples.length)
            tuples = Arrays.copyOf(tuples, Math.max(Sizes.more(tuples.length, WHAT), Sizes.of(width, size + 1L, WHAT)));
        System.arraycopy(source, offset, tuples, size * width, width);
        size++;
        if (2L * size > slots.length) rehash();
        return size - 1;
    }

    private boolean matches(int id, int[] source, int offset) {
        for (int i = 0, at = id * width; i < width; i++) {
            if (tuples[at + i] != source[offset + i]) return false;
        }
        return true;
    }

    private void rehash() {
        if (slots.length == MOST_SLOTS) { // it goes on while one slot is free
            if (size == MOST_SLOTS - 1) throw new TooLargeException(size, WHAT, MOST_SLOTS - 2);
            return;
        }
        slots = new int[2 * slots.length];
        Arrays.fill(slots, -1);
        int mask = slots.length - 1;
        for (int id = 0; id < size; id++) {
            int slot = hash.of(tuples, id * width) & mask;
            while (slots[slot] >= 0) slot = (slot + 1) & mask;
            slots[slot] = id;
        }
    }
}
