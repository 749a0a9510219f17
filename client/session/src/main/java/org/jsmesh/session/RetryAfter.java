package org.jsmesh.session;

import java.net.http.HttpHeaders;

/** What a server that is busy says of when to ask again (RFC 9110, 10.2.3), in seconds; dates are not read. */
final class RetryAfter {
    /** Nobody in front of a picture waits longer for one answer. */
    private static final int MOST_SECONDS = 30;

    private RetryAfter() {}

    /** 0 when nothing is said, or by another status than 429 and 503. */
    static long millis(int status, HttpHeaders headers) {
        if (status != 429 && status != 503) return 0;
        String seconds = headers.firstValue("Retry-After").orElse("").trim();
        if (!seconds.matches("[0-9]{1,9}")) return 0;
        return 1000L * Math.min(Integer.parseInt(seconds), MOST_SECONDS);
    }
}
