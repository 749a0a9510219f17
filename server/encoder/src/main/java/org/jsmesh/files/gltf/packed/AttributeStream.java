package org.jsmesh.files.gltf.packed;

import java.util.Arrays;

/**
 * Mode ATTRIBUTES (KHR_meshopt_compression, appendix A, mode 0), versions 0 and 1: blocks of elements, whose bytes are
 * stored one position after the other as differences to the element before.
 */
final class AttributeStream {
    private static final int HEADER = 0xA0;
    private static final int GROUP = 16;
    private static final int[] BITS_OF_VERSION_0 = {0, 2, 4, 8};
    private static final int[][] BITS_BY_CONTROL = {{0, 1, 2, 4}, {1, 2, 4, 8}};
    private static final int NOTHING = 2;
    private static final int LITERAL = 3;

    private final PackedBytes in;
    private final int version;
    private final int stride;
    private final int blockElements;
    /** What was read of a block: {@link #blockElements} differences for each byte of an element. */
    private final byte[] differences;

    private AttributeStream(PackedBytes in, int version, int stride) {
        this.in = in;
        this.version = version;
        this.stride = stride;
        blockElements = blockElements(stride);
        differences = new byte[blockElements * stride];
    }

    static byte[] decode(PackedBytes in, int count, int stride) throws PackedException {
        int header = in.next();
        int version = header - HEADER;
        if (version != 0 && version != 1) throw PackedBytes.unknownHeader(header);
        int channels = version == 0 ? 0 : stride / 4;
        int tail = in.takeTail(Math.max(stride + channels, version == 0 ? 32 : 24));
        if (leastBytes(version, count, stride) > in.remaining()) {
            throw new PackedException("the packed data is too short for " + count + " elements");
        }
        int baseline = in.bytes.length - channels - stride;
        assert baseline >= tail;
        byte[] last = Arrays.copyOfRange(in.bytes, baseline, baseline + stride);
        byte[] modes = Arrays.copyOfRange(in.bytes, in.bytes.length - channels, in.bytes.length);
        ElementChannels elements = new ElementChannels(last, modes, new byte[count * stride]);
        AttributeStream stream = new AttributeStream(in, version, stride);
        for (int from = 0; from < count; from += stream.blockElements) {
            int size = Math.min(count - from, stream.blockElements);
            stream.readBlock(size);
            elements.append(stream.differences, stream.blockElements, size);
        }
        in.requireEnd();
        return elements.values();
    }

    private static int blockElements(int stride) {
        return Math.min(8192 / stride & -GROUP, 256);
    }

    /** The bytes before the tail when every difference is zero. */
    private static long leastBytes(int version, int count, int stride) {
        int block = blockElements(stride);
        long whole = count / block;
        int rest = count % block;
        if (version == 1) return (whole + (rest > 0 ? 1 : 0)) * (stride / 4);
        return (whole * headerBytes(block) + headerBytes(rest)) * stride;
    }

    private static int headerBytes(int elements) {
        return (groups(elements) + 3) / 4;
    }

    private static int groups(int elements) {
        return (elements + GROUP - 1) / GROUP;
    }

    private void readBlock(int size) throws PackedException {
        int controls = version == 0 ? 0 : in.take(stride / 4);
        for (int k = 0; k < stride; k++) {
            int at = k * blockElements;
            if (version == 0) {
                readGroups(BITS_OF_VERSION_0, at, size);
                continue;
            }
            int control = in.bytes[controls + k / 4] >> k % 4 * 2 & 3;
            if (control == NOTHING) Arrays.fill(differences, at, at + size, (byte) 0);
            else if (control == LITERAL) System.arraycopy(in.bytes, in.take(size), differences, at, size);
            else readGroups(BITS_BY_CONTROL[control], at, size);
        }
    }

    private void readGroups(int[] bitsByMode, int at, int size) throws PackedException {
        int groups = groups(size);
        int header = in.take(headerBytes(size));
        for (int group = 0; group < groups; group++) {
            int mode = in.bytes[header + group / 4] >> group % 4 * 2 & 3;
            readGroup(bitsByMode[mode], at + group * GROUP);
        }
    }

    private void readGroup(int bits, int at) throws PackedException {
        if (bits == 0) {
            Arrays.fill(differences, at, at + GROUP, (byte) 0);
            return;
        }
        int from = in.take(GROUP * bits / 8);
        if (bits == 8) {
            System.arraycopy(in.bytes, from, differences, at, GROUP);
            return;
        }
        int sentinel = (1 << bits) - 1;
        for (int i = 0; i < GROUP; i++) {
            int bit = i * bits & 7;
            int value = in.bytes[from + i * bits / 8] >> (bits == 1 ? bit : 8 - bits - bit) & sentinel;
            differences[at + i] = (byte) (value == sentinel ? in.next() : value);
        }
    }
}
