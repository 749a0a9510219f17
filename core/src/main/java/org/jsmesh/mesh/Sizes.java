package org.jsmesh.mesh;

/**
 * Sizes of arrays. An array has at most {@value #MOST} elements, so products and sums of counts are checked here before
 * one is made: beyond that an int is silently another number.
 */
public final class Sizes {
    /** Most elements of an array, on every JVM. */
    public static final int MOST = Integer.MAX_VALUE - 8;

    private Sizes() {}

    /**
     * The elements of an array with some numbers for each of many things.
     *
     * @param width numbers for each
     * @param count how many things there are, 0 or more
     * @param what they are, for the message, for instance {@code faces}
     * @return {@code width * count}
     * @throws TooLargeException when no array holds them
     */
    public static int of(int width, long count, String what) {
        if (count > MOST / width) throw new TooLargeException(count, what, MOST / width);
        return width * (int) count;
    }

    /**
     * The elements of an array with one for each of many things.
     *
     * @param count how many there are, 0 or more
     * @param what they are, for the message
     * @return the count
     * @throws TooLargeException when no array holds them
     */
    public static int of(long count, String what) {
        return of(1, count, what);
    }

    /**
     * The new size of a full array: half as much again, as far as there can be such an array.
     *
     * @param length of the array
     * @param what its elements are, for the message
     * @return more than {@code length}
     * @throws TooLargeException when there is no larger array
     */
    public static int more(int length, String what) {
        if (length >= MOST) throw new TooLargeException(length + 1L, what, MOST);
        return (int) Math.min(MOST, Math.max(16, (long) length + (length >> 1)));
    }

    /**
     * The new size of a full array: twice the old one, as far as there can be such an array.
     *
     * @param length of the array, or of what it must hold at least
     * @param what its elements are, for the message
     * @return more than {@code length}
     * @throws TooLargeException when there is no larger array
     */
    public static int grown(int length, String what) {
        if (length < 0 || length >= MOST) throw new TooLargeException(length & 0xffffffffL, what, MOST);
        return (int) Math.min(MOST, Math.max(16, 2L * length));
    }
}
