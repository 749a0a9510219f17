package org.jsmesh.archive.coding;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.RangeDecoder;
import org.jsmesh.codec.entropy.RangeEncoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * The three coded parts of a base or a batch of splits as one payload, and where in it passes begin; see
 * {@link ArchiveLayout}.
 */
public final class SplitPayload {
    /**
     * Where a pass begins.
     *
     * @param splitsBefore splits since the pass before began, or since the payload began
     * @param drop by how many bits a sweep lowers the shift first
     */
    public record Start(int splitsBefore, int drop) {}

    /** A payload to decode. */
    public record Opened(List<Start> starts, BatchStreams streams) {}

    private final boolean hasAttributes;
    private final RangeEncoder connectivity = new RangeEncoder();
    private final RangeEncoder geometry = new RangeEncoder();
    private final RangeEncoder attributes = new RangeEncoder();
    private final List<Start> starts = new ArrayList<>();
    private int splits; // since a pass began
    private int allSplits;

    /**
     * Begins an empty payload.
     *
     * @param hasAttributes whether the mesh has attributes, without which there is one length less
     */
    public SplitPayload(boolean hasAttributes) {
        this.hasAttributes = hasAttributes;
    }

    /** {@return the parts, to be written to} */
    public BatchStreams streams() {
        return new BatchStreams(connectivity, geometry, attributes);
    }

    /** {@return an upper bound of what {@link #finish} will give} */
    public int estimatedBytes() {
        return connectivity.estimatedBytes()
                + geometry.estimatedBytes()
                + (hasAttributes ? attributes.estimatedBytes() : 0)
                + 6
                + 3 * starts.size()
                + ArchiveLayout.CRC_BYTES;
    }

    /**
     * A pass begins here.
     *
     * @param drop by how many bits a sweep lowers the shift first, within this payload
     */
    public void beginPass(int drop) {
        starts.add(new Start(splits, drop));
        splits = 0;
    }

    /**
     * Notes that splits were coded.
     *
     * @param count how many
     */
    public void countSplits(int count) {
        splits += count;
        allSplits += count;
    }

    /** {@return the number of splits in the payload} */
    public int splits() {
        return allSplits;
    }

    /** {@return the payload with its CRC-32} */
    public byte[] finish() {
        byte[] c = connectivity.finish();
        byte[] g = geometry.finish();
        byte[] a = hasAttributes ? attributes.finish() : new byte[0];
        int drops = 0;
        for (Start start : starts) drops += start.drop;
        byte[] head = new byte[10 + 10 * starts.size()];
        int at = 0;
        for (int i = 0; i < starts.size(); i++) {
            at = ArchiveLayout.putVarint(head, at, starts.get(i).splitsBefore);
            if (drops > 0 && i < starts.size() - 1) at = ArchiveLayout.putVarint(head, at, starts.get(i).drop);
        }
        at = ArchiveLayout.putVarint(head, at, c.length);
        if (hasAttributes) at = ArchiveLayout.putVarint(head, at, g.length);
        byte[] out = Arrays.copyOf(head, at + c.length + g.length + a.length + ArchiveLayout.CRC_BYTES);
        for (byte[] part : new byte[][] {c, g, a}) {
            System.arraycopy(part, 0, out, at, part.length);
            at += part.length;
        }
        ArchiveLayout.putInt(out, at, ArchiveLayout.crc(out, 0, at));
        return out;
    }

    /**
     * Opens a payload (without its CRC-32) for decoding.
     *
     * @param passes that begin in it
     * @param drops by how many bits the shift falls in it
     */
    public static Opened open(byte[] bytes, int offset, int length, boolean hasAttributes, int passes, int drops)
            throws MalformedStreamException {
        int end = offset + length;
        int[] cursor = {offset};
        List<Start> starts = new ArrayList<>();
        int dropsLeft = drops;
        for (int i = 0; i < passes; i++) {
            int splits = getVarint(bytes, cursor, end);
            int drop = drops > 0 && i < passes - 1 ? getVarint(bytes, cursor, end) : dropsLeft;
            if (drop > dropsLeft) throw new MalformedStreamException(-1, "a batch refines more than it says");
            dropsLeft -= drop;
            starts.add(new Start(splits, drop));
        }
        int c = getVarint(bytes, cursor, end);
        int g = hasAttributes ? getVarint(bytes, cursor, end) : end - cursor[0] - c;
        int at = cursor[0];
        if (c > end - at || g < 0 || g > end - at - c)
            throw new MalformedStreamException(-1, "the parts of a batch are longer than the batch");
        BinaryCoder first = new RangeDecoder(bytes, at, c);
        BinaryCoder second = new RangeDecoder(bytes, at + c, g);
        BinaryCoder third = new RangeDecoder(bytes, at + c + g, end - at - c - g);
        return new Opened(starts, new BatchStreams(first, second, third));
    }

    /**
     * Ends a range-coded stream.
     *
     * @param stream which is used up then
     * @return its bytes as a payload with its CRC-32
     */
    public static byte[] finish(RangeEncoder stream) {
        byte[] coded = stream.finish();
        byte[] out = Arrays.copyOf(coded, coded.length + ArchiveLayout.CRC_BYTES);
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
