package org.jsmesh.archive;

import org.jsmesh.codec.BinaryCoder;
import org.jsmesh.codec.MeshCoder;
import org.jsmesh.codec.RangeDecoder;
import org.jsmesh.codec.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;

/** The three coded parts of a base or a batch of splits as one payload, see {@link ArchiveLayout}. */
final class SplitPayload {
    private final boolean hasAttributes;
    private final RangeEncoder connectivity = new RangeEncoder();
    private final RangeEncoder geometry = new RangeEncoder();
    private final RangeEncoder attributes = new RangeEncoder();

    SplitPayload(boolean hasAttributes) {
        this.hasAttributes = hasAttributes;
    }

    MeshCoder.Streams streams() {
        return new MeshCoder.Streams(connectivity, geometry, attributes);
    }

    /** An upper bound of what {@link #finish} will give. */
    int estimatedBytes() {
        return connectivity.estimatedBytes()
                + geometry.estimatedBytes()
                + (hasAttributes ? attributes.estimatedBytes() : 0)
                + 6
                + ArchiveLayout.CRC_BYTES;
    }

    /** The payload with its CRC-32. */
    byte[] finish() {
        byte[] c = connectivity.finish();
        byte[] g = geometry.finish();
        byte[] a = hasAttributes ? attributes.finish() : new byte[0];
        int head = ArchiveLayout.varintBytes(c.length) + (hasAttributes ? ArchiveLayout.varintBytes(g.length) : 0);
        byte[] out = new byte[head + c.length + g.length + a.length + ArchiveLayout.CRC_BYTES];
        int at = ArchiveLayout.putVarint(out, 0, c.length);
        if (hasAttributes) at = ArchiveLayout.putVarint(out, at, g.length);
        for (byte[] part : new byte[][] {c, g, a}) {
            System.arraycopy(part, 0, out, at, part.length);
            at += part.length;
        }
        ArchiveLayout.putInt(out, at, ArchiveLayout.crc(out, 0, at));
        return out;
    }

    /** Opens a payload (without its CRC-32) for decoding. */
    static MeshCoder.Streams open(byte[] bytes, int offset, int length, boolean hasAttributes)
            throws MalformedStreamException {
        int end = offset + length;
        int[] cursor = {offset};
        int c = getVarint(bytes, cursor, end);
        int g = hasAttributes ? getVarint(bytes, cursor, end) : end - cursor[0] - c;
        int at = cursor[0];
        if (c > end - at || g < 0 || g > end - at - c)
            throw new MalformedStreamException(-1, "the parts of a batch are longer than the batch");
        BinaryCoder first = new RangeDecoder(bytes, at, c);
        BinaryCoder second = new RangeDecoder(bytes, at + c, g);
        return new MeshCoder.Streams(first, second, new RangeDecoder(bytes, at + c + g, end - at - c - g));
    }

    /** A range-coded stream as a payload with its CRC-32. */
    static byte[] finish(RangeEncoder stream) {
        byte[] coded = stream.finish();
        byte[] out = java.util.Arrays.copyOf(coded, coded.length + ArchiveLayout.CRC_BYTES);
        ArchiveLayout.putInt(out, coded.length, ArchiveLayout.crc(coded, 0, coded.length));
        return out;
    }

    private static int getVarint(byte[] bytes, int[] cursor, int end) throws MalformedStreamException {
        int value = 0;
        for (int shift = 0; shift <= 28; shift += 7) {
            if (cursor[0] >= end) throw new MalformedStreamException(-1, "a batch ends in its first bytes");
            byte b = bytes[cursor[0]++];
            value |= (b & 0x7f) << shift;
            if (b >= 0) {
                if (value < 0) break;
                return value;
            }
        }
        throw new MalformedStreamException(-1, "a length is too large");
    }
}
