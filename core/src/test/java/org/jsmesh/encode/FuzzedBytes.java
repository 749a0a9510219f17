package org.jsmesh.encode;

/** Makes choices of bytes, one after the other; without more bytes all choices are the first. */
final class FuzzedBytes {
    private final byte[] bytes;
    private int at;

    FuzzedBytes(byte[] bytes) {
        this.bytes = bytes;
    }

    boolean isTrue() {
        return (next() & 1) != 0;
    }

    /** A number of those from one to another. */
    int from(int low, int high) {
        long range = (long) high - low + 1;
        long number = range <= 256 ? next() & 0xff : Integer.toUnsignedLong(bits());
        return (int) (low + number % range);
    }

    <T> T of(T[] choices) {
        return choices[from(0, choices.length - 1)];
    }

    byte next() {
        return at < bytes.length ? bytes[at++] : 0;
    }

    int bits() {
        int bits = 0;
        for (int i = 0; i < Integer.BYTES; i++) bits = bits << 8 | next() & 0xff;
        return bits;
    }

    long manyBits() {
        return (long) bits() << 32 | Integer.toUnsignedLong(bits());
    }
}
