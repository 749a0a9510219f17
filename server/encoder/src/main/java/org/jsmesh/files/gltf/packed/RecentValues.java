package org.jsmesh.files.gltf.packed;

/** The sixteen values that were added last. */
final class RecentValues {
    private static final int MOST = 16;
    private final int[] values = new int[MOST];
    private int added;

    void add(int value) {
        values[added % MOST] = value;
        // Sixteen more than sixteen means the same, and never grows out of an int.
        if (++added == 3 * MOST) added -= MOST;
    }

    /** The value that was added {@code age} values before the last one. */
    int get(int age) throws PackedException {
        if (age >= added) throw new PackedException("a triangle refers to one that is not there");
        return values[(added - 1 - age) % MOST];
    }
}
