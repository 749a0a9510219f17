package org.jsmesh.memory;

import java.io.IOException;

/**
 * Reads parts of a file, wherever it lies, and perhaps not all of them: for who looks at a file before reading it. Who
 * reads it whole takes an {@link org.jsmesh.mesh.io.ByteSource}.
 */
@FunctionalInterface
public interface ByteRanges {
    /**
     * Reads bytes. They may be fewer than asked for where the source has no more at hand: a source that knows only the
     * first bytes of a file gives no byte of what lies behind them.
     *
     * @param from the first byte's place in the file, not negative
     * @param bytes at most so many
     * @return what is there, from that place on
     * @throws IOException when the source cannot be read
     */
    byte[] read(long from, int bytes) throws IOException;

    /**
     * {@return how many samples of text may be read, at least 2: few where each takes a request, so that the estimate
     * is less sure}
     */
    default int samples() {
        return Sampled.SAMPLES;
    }

    /**
     * {@return a source that has the beginning of a file alone}
     *
     * @param start the first bytes, not changed
     */
    static ByteRanges ofStart(byte[] start) {
        return (from, bytes) -> {
            if (from >= start.length) return new byte[0];
            int at = (int) from;
            return java.util.Arrays.copyOfRange(start, at, (int) Math.min(start.length, at + (long) bytes));
        };
    }
}
