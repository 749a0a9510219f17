package org.jsmesh.mesh.io;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;

/**
 * Bytes that may be more than an array holds, and that are read from their start or another place as often as needed.
 * Each reading gives the same bytes, to the end: this is for who reads a model. A look at parts of a file that may not
 * all be at hand is another thing ({@code org.jsmesh.memory.ByteRanges} of the encoder).
 */
public interface ByteSource {
    /** {@return how many bytes there are} */
    long length();

    /**
     * Begins to read.
     *
     * @param offset of the first byte to read, 0 to {@link #length}
     * @return the bytes from there on
     * @throws IOException when they cannot be read
     */
    InputStream from(long offset) throws IOException;

    /**
     * Takes bytes in memory.
     *
     * @param content shared, not copied; must not change
     * @return a source of them
     */
    static ByteSource of(byte[] content) {
        return new Held(content);
    }

    /**
     * Bytes in memory, which need not be read in portions.
     *
     * @param content all of them, shared
     */
    record Held(byte[] content) implements ByteSource {
        @Override
        public long length() {
            return content.length;
        }

        @Override
        public InputStream from(long offset) {
            int at = (int) Math.min(offset, content.length);
            return new ByteArrayInputStream(content, at, content.length - at);
        }
    }
}
