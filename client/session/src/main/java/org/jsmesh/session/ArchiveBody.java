package org.jsmesh.session;

import java.io.IOException;

/**
 * The answer to one request for bytes of an archive, read part by part as it arrives. Used by the session's thread
 * alone.
 */
interface ArchiveBody {
    /** A part of the answer: first a head, then bytes, then the end. */
    sealed interface Part permits Head, Bytes, End {}

    /**
     * The answer has begun.
     *
     * @param fromByte byte of the archive with which the body begins
     * @param toByte byte of the archive after the body's last; −1 when not said
     * @param archiveBytes size of the archive; −1 when not said
     * @param entityTag strong entity tag of the archive with its quotes, or null
     * @param ranged false when the server sent the whole archive although a range was asked for
     */
    record Head(long fromByte, long toByte, long archiveBytes, String entityTag, boolean ranged) implements Part {}

    /**
     * Bytes of the body.
     *
     * @param atMillis when they arrived, on the session's clock
     */
    record Bytes(byte[] array, int length, double atMillis) implements Part {}

    /** The body is complete. */
    record End() implements Part {}

    /**
     * The next part, or null when none came within the time. While nobody calls this, reading stops and holds the
     * sender back.
     *
     * @throws FetchException when the answer is not the archive
     * @throws IOException when the connection broke
     */
    Part poll(long timeoutMillis) throws IOException;

    /** Gives up the rest. */
    void cancel();

    /** The address asked. */
    String url();

    /** The Range header sent, or null. */
    String range();

    /** True when the answer came by HTTP/2. */
    boolean isHttp2();
}
