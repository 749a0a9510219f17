package org.jsmesh.store;

/** Who asked for an encoding, and when last. A wish that nobody renews goes off the queue. Thread-safe. */
final class Wish {
    private static final long LEASE_NANOS = 30_000_000_000L;

    private final String client;
    private volatile long askedNanos = System.nanoTime();
    private volatile boolean lasting;

    /** @param client who asked first, any text; null for a wish that lasts until it is fulfilled */
    Wish(String client) {
        this.client = client;
        lasting = client == null;
    }

    /** Who asked first, or null. */
    String client() {
        return client;
    }

    /** Somebody asks again. */
    void renew(String by) {
        askedNanos = System.nanoTime();
        if (by == null) lasting = true;
    }

    /** Whether those who asked have gone away. */
    boolean isGone() {
        return !lasting && System.nanoTime() - askedNanos > LEASE_NANOS;
    }
}
