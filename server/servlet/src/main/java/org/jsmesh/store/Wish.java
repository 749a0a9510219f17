package org.jsmesh.store;

/** Who asked for an encoding, and when last. A wish that nobody renews goes off the queue. Thread-safe. */
final class Wish {
    private final String client;
    private final long leaseNanos;
    private volatile long askedNanos = System.nanoTime();
    private volatile boolean lasting;

    /**
     * @param client who asked first, any text; null for a wish that lasts until it is fulfilled
     * @param leaseMillis after which it is gone if nobody asks again
     */
    Wish(String client, long leaseMillis) {
        this.client = client;
        leaseNanos = leaseMillis * 1_000_000;
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
        return !lasting && System.nanoTime() - askedNanos > leaseNanos;
    }
}
