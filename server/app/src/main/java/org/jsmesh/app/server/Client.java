package org.jsmesh.app.server;

import java.util.concurrent.atomic.AtomicInteger;

/** Counts the connections and requests of one client address, or of one IPv6 network of 64 bits. Thread-safe. */
final class Client {
    private final String address;
    private final AtomicInteger requests = new AtomicInteger();

    /** Connections and requests that keep this object in the map of {@link Clients}; changed under its lock alone. */
    int holders;

    /** Connections among them, likewise. */
    int connections;

    Client(String address) {
        this.address = address;
    }

    String address() {
        return address;
    }

    /** Counts one more request unless there are {@code most} already. */
    boolean begin(int most) {
        if (requests.incrementAndGet() <= most) return true;
        requests.decrementAndGet();
        return false;
    }

    void end() {
        requests.decrementAndGet();
    }
}
