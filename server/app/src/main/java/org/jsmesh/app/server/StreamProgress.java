package org.jsmesh.app.server;

/**
 * Progress of a portion of an answer, seen at looks now and then. Streams of one connection share its time. For one
 * thread.
 */
final class StreamProgress {
    private long sinceNanos;
    private long lookedNanos;
    private long spentNanos;
    private long resetNanos;

    /**
     * Takes note of the time since the last look.
     *
     * @param since when the connection was given the portion
     * @param sharing answers that the connection is sending, this one included
     */
    void look(long since, long now, int sharing) {
        if (since != sinceNanos) {
            sinceNanos = since;
            lookedNanos = since;
            spentNanos = 0;
        }
        // Not the whole time divided by the streams that share now, because others may just have got their last byte.
        spentNanos += Math.max(0, now - lookedNanos) / sharing;
        lookedNanos = now;
    }

    /**
     * Time that the portion has had for itself: the time since it was given, divided by the streams that shared the
     * connection.
     */
    long spentNanos() {
        return spentNanos;
    }

    /** Since when the connection has been taking the portion. */
    long sinceNanos() {
        return sinceNanos;
    }

    /** When the stream was reset, or 0. */
    long resetNanos() {
        return resetNanos;
    }

    void reset(long now) {
        resetNanos = now;
    }
}
