package org.jsmesh.archive.coding;

import java.util.zip.CRC32;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.UpAxis;

/**
 * Magic, version and the byte layout of an archive; all integers little endian.
 *
 * <pre>
 * 0   'j' 'S' 'M' version
 * 4   features that a reader must know, a bit each; the last two are the axis that points up
 * 5   varint H: bytes of the opening
 *     opening: format, materials, the index of the first batches (H bytes)
 *     u32 CRC-32 of all bytes so far
 *     base payload, u32 CRC-32 of it
 *     batch payload, u32 CRC-32 of it     (as often as the index says)
 * </pre>
 *
 * A payload of the base or of splits begins with varints that say where passes begin in it, see {@link SplitPayload}.
 * The lengths of its connectivity and geometry parts follow as varints (the latter only when there are attributes),
 * then connectivity, geometry and attributes. A texture payload is bytes of the images, one after the other.
 */
public final class ArchiveLayout {
    /** Version of the format, the fourth byte of an archive. */
    public static final int VERSION = 2;
    /** Where the features begin that a reader must know. */
    public static final int FEATURES_AT = 4;
    /** Where the length of the opening begins. */
    public static final int OPENING_BYTES_AT = 5;

    public static final int MOST_LENGTH_BYTES = 4; // of a varint that says how long the opening is

    /** Feature 0: there are batches with the original's order. */
    public static final int ORDER = 1;

    /** Feature 1: components may come after the base. */
    public static final int COMPONENTS = 2;

    /** Feature 2: there are numbers that are neither float32 nor 8 bits, or attributes of faces. */
    public static final int REMAINDER = 4;

    /** Feature 3: the last batch is a poster. */
    public static final int POSTER = 8;

    /** Feature 4: the original bounds a solid, see {@link org.jsmesh.mesh.ClosedSurface}. */
    public static final int CLOSED = 16;

    /** Feature 5: the opening begins with further features, from feature 8 on, as one number. */
    public static final int FURTHER = 32;

    /** The first of the further features. */
    static final int FIRST_FURTHER = 8;

    /** Feature 8: the header tells the quantiles of the errors, see {@link QuantileColumn}. */
    public static final int QUANTILES = 1 << FIRST_FURTHER;

    /** Features 6 and 7 are a number: the axis that points up, as the ordinal of an {@link UpAxis}. */
    private static final int UP_SHIFT = 6;

    /** The features that this version knows, as bits. */
    public static final int KNOWN_FEATURES =
            ORDER | COMPONENTS | REMAINDER | POSTER | CLOSED | FURTHER | QUANTILES | 3 << UP_SHIFT;

    /** Bytes of a checksum. */
    public static final int CRC_BYTES = 4;
    /** The first three bytes of an archive. Not to be changed. */
    public static final byte[] MAGIC = {'j', 'S', 'M'};

    private ArchiveLayout() {}

    /**
     * The features that tell the axis that points up.
     *
     * @param up the axis
     * @return bits of the byte with the features
     */
    public static int feature(UpAxis up) {
        return up.ordinal() << UP_SHIFT;
    }

    /**
     * Reads the axis that points up.
     *
     * @param features the byte with the features
     * @return the axis
     * @throws MalformedStreamException when it is none
     */
    public static UpAxis up(int features) throws MalformedStreamException {
        return switch (features >> UP_SHIFT & 3) {
            case 0 -> UpAxis.UNKNOWN;
            case 1 -> UpAxis.Y;
            case 2 -> UpAxis.Z;
            default -> throw new MalformedStreamException(FEATURES_AT, "the axis that points up is none");
        };
    }

    /**
     * Puts a number as 4 bytes, low first.
     *
     * @param bytes where it goes
     * @param at place of the first byte
     * @param value the number
     */
    public static void putInt(byte[] bytes, int at, int value) {
        for (int i = 0; i < 4; i++) bytes[at + i] = (byte) (value >> 8 * i);
    }

    static int getInt(byte[] bytes, int at) {
        int value = 0;
        for (int i = 3; i >= 0; i--) value = value << 8 | bytes[at + i] & 0xff;
        return value;
    }

    /**
     * Counts the bytes that {@link #putVarint} takes.
     *
     * @param value taken as unsigned
     * @return 1 to 5
     */
    public static int varintBytes(int value) {
        int n = 1;
        for (int v = value >>> 7; v != 0; v >>>= 7) n++;
        return n;
    }

    /**
     * Puts a number as 7 bits per byte, low first.
     *
     * @param out where it goes
     * @param at place of the first byte
     * @param value taken as unsigned
     * @return where the next byte goes
     */
    public static int putVarint(byte[] out, int at, int value) {
        int end = at;
        int v = value;
        for (; v >>> 7 != 0; v >>>= 7) out[end++] = (byte) (v & 0x7f | 0x80);
        out[end++] = (byte) v;
        return end;
    }

    /**
     * Computes the CRC-32 of some bytes.
     *
     * @param bytes an array that holds them
     * @param offset of the first of them
     * @param length number of bytes
     * @return the checksum as it stands in an archive
     */
    public static int crc(byte[] bytes, int offset, int length) {
        CRC32 crc = new CRC32();
        crc.update(bytes, offset, length);
        return (int) crc.getValue();
    }

    /** Checks the CRC-32 that follows some bytes. */
    public static void checkCrc(byte[] bytes, int offset, int length, long fileOffset) throws MalformedStreamException {
        if (crc(bytes, offset, length) != getInt(bytes, offset + length)) {
            throw new MalformedStreamException(
                    fileOffset, "the checksum does not match: the file is damaged; fetch it again");
        }
    }
}
