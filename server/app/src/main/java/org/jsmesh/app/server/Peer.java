package org.jsmesh.app.server;

import org.eclipse.jetty.io.EndPoint;

/** The other end of an open connection. */
final class Peer {
    private final EndPoint endPoint;
    private final Client client;
    private final boolean proxy;
    private final boolean excess;
    private final long openedNanos = System.nanoTime();

    /** Since when no HTTP/2 stream is open, or 0; used by the one thread that checks connections. */
    long idleNanos;

    /** Whether it was closed because it was slow; used by the same thread. */
    boolean isDropped;

    /** When its client was told that the server stops, or 0; used by the same thread. */
    long farewellNanos;

    private long movedBytes;
    private long movedNanos;

    /**
     * @param client behind the connection; when it is a proxy, the proxy itself
     * @param excess whether the connection is beyond the limit
     */
    Peer(EndPoint endPoint, Client client, boolean proxy, boolean excess) {
        this.endPoint = endPoint;
        this.client = client;
        this.proxy = proxy;
        this.excess = excess;
    }

    /**
     * Takes note of how far the connection is. Only for the one thread that checks connections.
     *
     * @param sending whether there is anything to send
     * @param bytes that the connection has taken
     */
    void watch(boolean sending, long bytes, long now) {
        if (sending && movedNanos != 0 && bytes - movedBytes < Limits.PORTION_BYTES) return;
        movedBytes = bytes;
        movedNanos = now;
    }

    /** Since when the connection has taken less than a portion of what there was to send. */
    long movedNanos() {
        return movedNanos;
    }

    EndPoint endPoint() {
        return endPoint;
    }

    Client client() {
        return client;
    }

    boolean isProxy() {
        return proxy;
    }

    boolean isExcess() {
        return excess;
    }

    long openedNanos() {
        return openedNanos;
    }
}
