package org.jsmesh.encode.write;

import java.nio.ByteBuffer;
import java.util.List;
import org.jsmesh.archive.coding.ArchiveLayout;

/**
 * The bytes of a batch. Those of images stay where they are: an archive may be larger than an array, and larger than
 * the memory that a copy takes.
 *
 * @param bytes all of them, or those in front of the checksum
 * @param sum the checksum where it is apart, else empty
 */
record Payload(ByteBuffer bytes, ByteBuffer sum) {
    private static final ByteBuffer NONE = ByteBuffer.allocate(0);

    /** @param all with the checksum */
    static Payload of(byte[] all) {
        return new Payload(ByteBuffer.wrap(all), NONE);
    }

    /** Some bytes of an array, which must not change. */
    static Payload verbatim(byte[] all, int from, int size) {
        byte[] sum = new byte[ArchiveLayout.CRC_BYTES];
        ArchiveLayout.putInt(sum, 0, ArchiveLayout.crc(all, from, size));
        return new Payload(ByteBuffer.wrap(all, from, size), ByteBuffer.wrap(sum));
    }

    int length() {
        return bytes.remaining() + sum.remaining();
    }

    void addTo(List<ByteBuffer> parts) {
        parts.add(bytes);
        if (sum.hasRemaining()) parts.add(sum);
    }
}
