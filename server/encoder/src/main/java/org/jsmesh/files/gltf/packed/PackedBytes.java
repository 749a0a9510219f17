package org.jsmesh.files.gltf.packed;

import java.nio.ByteBuffer;

/** Packed bytes that are read once, from the front to an end that a tail may have moved. */
public final class PackedBytes {
    /** All bytes, those before and behind what is read, too. */
    public final byte[] bytes;

    private int at;
    private int end;

    /** @param packed the bytes, from position to limit; neither is changed */
    public PackedBytes(ByteBuffer packed) {
        bytes = new byte[packed.remaining()];
        packed.get(packed.position(), bytes);
        end = bytes.length;
    }

    private PackedBytes(byte[] bytes, int at, int end) {
        this.bytes = bytes;
        this.at = at;
        this.end = end;
    }

    /** @return where in {@link #bytes} the next byte is */
    public int position() {
        return at;
    }

    /** @return where in {@link #bytes} the bytes end */
    public int end() {
        return end;
    }

    /** @return how many bytes are left */
    public int remaining() {
        return end - at;
    }

    /**
     * Reads a byte.
     *
     * @return the byte, unsigned
     * @throws PackedException when there are too few bytes
     */
    public int next() throws PackedException {
        return bytes[take(1)] & 0xFF;
    }

    /**
     * Reads a number.
     *
     * @return the next two bytes, little endian, unsigned
     * @throws PackedException when there are too few bytes
     */
    public int nextShort() throws PackedException {
        return next() | next() << 8;
    }

    /**
     * Reads a number.
     *
     * @return the next four bytes, little endian
     * @throws PackedException when there are too few bytes
     */
    public int nextInt() throws PackedException {
        return nextShort() | nextShort() << 16;
    }

    /**
     * Reads a number.
     *
     * @return the next four bytes as a float, little endian
     * @throws PackedException when there are too few bytes
     */
    public float nextFloat() throws PackedException {
        return Float.intBitsToFloat(nextInt());
    }

    /**
     * Steps over some bytes.
     *
     * @param count how many
     * @return where in {@link #bytes} they begin
     * @throws PackedException when there are too few bytes
     */
    public int take(int count) throws PackedException {
        if (count > remaining()) throw tooShort();
        at += count;
        return at - count;
    }

    /** Cuts bytes off the end. Returns where in {@link #bytes} they begin. */
    int takeTail(int count) throws PackedException {
        if (count > remaining()) throw tooShort();
        end -= count;
        return end;
    }

    /**
     * Steps over some bytes.
     *
     * @param count how many
     * @return a reader of these
     * @throws PackedException when there are too few bytes
     */
    public PackedBytes takePart(int count) throws PackedException {
        int from = take(count);
        return new PackedBytes(bytes, from, from + count);
    }

    /**
     * Reads a number of seven bits per byte, the lowest first, in at most five bytes.
     *
     * @return the number
     * @throws PackedException when there are too few bytes or too many for a number
     */
    public int varint() throws PackedException {
        int value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            int next = next();
            value |= (next & 0x7F) << shift;
            if (next < 0x80) return value;
        }
        throw new PackedException("a number of the packed data has more than five bytes");
    }

    /**
     * Reads a number of things, as {@link #varint} does.
     *
     * @return the number, not negative
     * @throws PackedException when there are too few bytes or the number is out of range
     */
    public int count() throws PackedException {
        int count = varint();
        if (count < 0) throw new PackedException("a count of the packed data is out of range");
        return count;
    }

    void requireHeader(int header) throws PackedException {
        int found = next();
        if (found != header) throw unknownHeader(found);
    }

    static PackedException unknownHeader(int found) {
        return new PackedException(
                "the packed data begins with the byte " + found + ", which its compression mode does not know");
    }

    void requireEnd() throws PackedException {
        if (at != end) throw new PackedException("the packed data has " + (end - at) + " bytes left over");
    }

    private static PackedException tooShort() {
        return new PackedException("the packed data ends too early");
    }
}
