package org.jsmesh.files;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.security.MessageDigest;
import java.util.HexFormat;
import org.jsmesh.mesh.io.ByteSource;

/** Hashes the bytes of a source while somebody reads all of them. */
final class HashedSource implements ByteSource {
    private final ByteSource source;
    private String sha256;
    private boolean differs;

    HashedSource(ByteSource source) {
        this.source = source;
    }

    /** The SHA-256 of what was read; null when nobody has read all of it, or two have read different bytes. */
    String sha256() {
        return differs ? null : sha256;
    }

    @Override
    public long length() {
        return source.length();
    }

    @Override
    public InputStream from(long offset) throws IOException {
        InputStream in = source.from(offset);
        return offset == 0 ? new Hashing(in) : in;
    }

    private final class Hashing extends FilterInputStream {
        private final MessageDigest digest = Hashes.digest();
        private long count;

        Hashing(InputStream in) {
            super(in);
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] bytes, int offset, int length) throws IOException {
            int read = super.read(bytes, offset, length);
            if (read <= 0) return read;
            digest.update(bytes, offset, read);
            count += read;
            if (count == length()) end();
            return read;
        }

        private void end() {
            String hash = HexFormat.of().formatHex(digest.digest());
            differs |= sha256 != null && !sha256.equals(hash);
            sha256 = hash;
        }

        @Override
        public long skip(long bytes) {
            throw new UnsupportedOperationException("what is skipped is not hashed");
        }

        @Override
        public boolean markSupported() {
            return false;
        }
    }
}
