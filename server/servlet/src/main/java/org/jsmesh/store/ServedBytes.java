package org.jsmesh.store;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;

/** The bytes of an archive for one answer, some at a time. Not thread-safe. */
public interface ServedBytes extends AutoCloseable {
    /** Bytes that are there. */
    CompletableFuture<?> HERE = CompletableFuture.completedFuture(null);

    /**
     * Fetches bytes from where they lie, as far as that takes time.
     *
     * @param offset of the first byte from the start of the archive
     * @param length most bytes wanted, at least 1
     * @return completes when {@link #next} gives some of them without waiting, or says why it cannot
     */
    default CompletableFuture<?> ready(long offset, long length) {
        return HERE;
    }

    /**
     * Some of the bytes from {@code offset} on, at least one. They stay as they are until the next call.
     *
     * @param offset of the first byte from the start of the archive, as {@link #ready} was told
     * @param length most bytes wanted, at least 1
     * @return a view of them
     * @throws IllegalArgumentException when the range is not within the archive
     * @throws IOException when they cannot be read any more, or are others by now
     */
    ByteBuffer next(long offset, long length) throws IOException;

    /** To be called when no view is in use any more. */
    @Override
    void close();

    /** Closes while a view may be in use: its buffer is left to the collector. */
    void abandon();
}
