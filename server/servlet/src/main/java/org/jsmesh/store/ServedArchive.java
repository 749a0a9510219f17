package org.jsmesh.store;

import java.util.concurrent.CompletableFuture;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;

/** An archive whose bytes can be sent, wherever they lie. Thread-safe. */
public interface ServedArchive {
    /** {@return its size} */
    long bytes();

    /** {@return the SHA-256 of its bytes, in lower-case hexadecimal} */
    String sha256();

    /** {@return what the archive says of itself} */
    ArchiveHeader header();

    /** {@return the index, with the place of every batch} */
    default BatchIndex batches() {
        return header().batches();
    }

    /**
     * Begins to read.
     *
     * @param length bytes that are to be read, as far as that is known
     * @return a reader; null when the archive was closed
     */
    ServedBytes reader(long length);

    /**
     * Reads some bytes.
     *
     * @param offset of the first byte from the start of the archive
     * @param length number of bytes
     * @return completes with a copy of them
     * @throws IllegalArgumentException when the range is not within the archive
     */
    CompletableFuture<byte[]> read(long offset, int length);
}
