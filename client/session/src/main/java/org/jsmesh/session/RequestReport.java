package org.jsmesh.session;

/**
 * One request of a session, as its trace keeps it. Times are milliseconds since the session was opened.
 *
 * @param url that was asked for
 * @param range the value of the Range header, or null when none was sent
 * @param startMillis when it was sent
 * @param firstByteMillis when the first byte of the body arrived; −1 when none did
 * @param endMillis when the last byte arrived, or the request was given up
 * @param bytes of the body received
 * @param http2 whether the answer came by HTTP/2
 */
public record RequestReport(
        String url, String range, long startMillis, long firstByteMillis, long endMillis, long bytes, boolean http2) {}
