package org.jsmesh.app;

import org.eclipse.jetty.io.EndPoint;

/** The other end of an open connection. */
final class Peer {
    private final EndPoint endPoint;
    private final Client client;
    private final boolean proxy;
    private final boolean excess;
    private final long openedNanos = System.nanoTime();

    /** Since when no stream of HTTP/2 is open, or 0; used by the one thread that looks after connections. */
    long idleNanos;

    /**
     * @param client behind the connection; when it is a proxy, the proxy itself
     * @param excess whether there were enough connections without it
     */
    Peer(EndPoint endPoint, Client client, boolean proxy, boolean excess) {
        this.endPoint = endPoint;
        this.client = client;
        this.proxy = proxy;
        this.excess = excess;
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
