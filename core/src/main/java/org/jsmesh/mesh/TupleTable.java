package org.jsmesh.mesh;

import java.util.Arrays;

/**
 * Gives equal tuples of a fixed number of ints the same id, counted from 0 in the order met. It compares tuples
 * exactly; hashes only find the place to look.
 */
final class TupleTable {
    private static final int FREE = -1;
    private static final int MOST_SLOTS = 1 << 30;
    private static final String WHAT = "different rows of numbers";

    private final int length;
    private final TupleHash hash;
    private int[] tuples;
    private int[] slots;
    private int size;

    /**
     * @param length ints per tuple
     * @param expected number of distinct tuples to make room for
     */
    TupleTable(int length, int expected) {
        this.length = length;
        hash = new TupleHash(length);
        tuples = new int[Sizes.of(length, Math.max(16, expected), WHAT)];
        slots = new int[(int) Math.min(MOST_SLOTS, Integer.highestOneBit(Math.max(16, expected)) * 4L)];
        Arrays.fill(slots, FREE);
    }

    /** Number of distinct tuples. */
    int size() {
        return size;
    }

    /** Word {@code i} of the tuple with this id. */
    int word(int id, int i) {
        return tuples[id * length + i];
    }

    /** The id of the tuple that begins at {@code from}; a new one when it was not met before. */
    int intern(int[] words, int from) {
        int slot = find(words, from);
        if (slots[slot] != FREE) return slots[slot];
        if ((size + 1L) * length > tuples.length)
            tuples = Arrays.copyOf(
                    tuples, Math.max(Sizes.of(length, size + 1L, WHAT), Sizes.grown(tuples.length, WHAT)));
        System.arraycopy(words, from, tuples, size * length, length);
        slots[slot] = size++;
        if (2L * size > slots.length) grow();
        return size - 1;
    }

    private int find(int[] words, int from) {
        int mask = slots.length - 1;
        int slot = hash.of(words, from) & mask;
        while (slots[slot] != FREE) {
            int at = slots[slot] * length;
            if (Arrays.equals(words, from, from + length, tuples, at, at + length)) return slot;
            slot = (slot + 1) & mask;
        }
        return slot;
    }

    private void grow() {
        if (slots.length == MOST_SLOTS) { // it goes on while one slot is free
            if (size == MOST_SLOTS - 1) throw new TooLargeException(size, WHAT, MOST_SLOTS - 2);
            return;
        }
        slots = new int[2 * slots.length];
        Arrays.fill(slots, FREE);
        for (int id = 0; id < size; id++) slots[find(tuples, id * length)] = id;
    }
}
