package org.jsmesh.mesh;

/** Collects numbers to hash, four bytes each, little endian, so that the hash is not called for each. */
final class HashedNumbers {
    private final MeshIdentity.Hash hash;
    private final byte[] buffer = new byte[1 << 12];
    private int filled;

    HashedNumbers(MeshIdentity.Hash hash) {
        this.hash = hash;
    }

    void updateInt(int value) {
        if (filled == buffer.length) flush();
        buffer[filled] = (byte) value;
        buffer[filled + 1] = (byte) (value >>> 8);
        buffer[filled + 2] = (byte) (value >>> 16);
        buffer[filled + 3] = (byte) (value >>> 24);
        filled += 4;
    }

    void update(byte[] bytes) {
        flush();
        hash.update(bytes, 0, bytes.length);
    }

    void flush() {
        hash.update(buffer, 0, filled);
        filled = 0;
    }
}
