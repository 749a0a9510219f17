package org.jsmesh.files.gltf.packed;

/** Indices as bytes, little endian, in two or four bytes each; what does not fit into two is cut. */
final class IndexOutput {
    private final byte[] values;
    private final int stride;
    private int at;

    IndexOutput(int count, int stride) {
        values = new byte[count * stride];
        this.stride = stride;
    }

    void put(int index) {
        values[at] = (byte) index;
        values[at + 1] = (byte) (index >> 8);
        if (stride == 4) {
            values[at + 2] = (byte) (index >> 16);
            values[at + 3] = (byte) (index >> 24);
        }
        at += stride;
    }

    byte[] values() {
        return values;
    }
}
