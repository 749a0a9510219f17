package org.jsmesh.files.gltf.packed;

/**
 * Mode INDICES (KHR_meshopt_compression, appendix A, mode 2): each index is a difference to one of two that were read
 * before.
 */
final class IndexStream {
    private static final int HEADER = 0xD1;
    private static final int TAIL_BYTES = 4;

    private IndexStream() {}

    static byte[] decode(PackedBytes in, int count, int stride) throws PackedException {
        in.requireHeader(HEADER);
        in.takeTail(TAIL_BYTES);
        if (count > in.remaining()) throw new PackedException("the packed data is too short for " + count + " indices");
        IndexOutput indices = new IndexOutput(count, stride);
        int[] last = new int[2];
        for (int i = 0; i < count; i++) {
            int packed = in.varint();
            int baseline = packed & 1;
            last[baseline] += packed >>> 2 ^ -(packed >>> 1 & 1);
            indices.put(last[baseline]);
        }
        in.requireEnd();
        return indices.values();
    }
}
