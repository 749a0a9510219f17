package org.jsmesh.session;

/**
 * How a {@link StreamingSession} behaves.
 *
 * @param serverPlan true: the server's {@code patches} resource turns bandwidth and wait into batches (the paper's way); false: the client asks for the same
 *     batches by ranges, which works on any static host
 * @param attempts how often a request is tried without receiving a byte before the session gives up
 * @param backoffMillis pause before the second attempt; doubled for each further one, up to 16 times
 * @param stallMillis a connection that delivers nothing for so long counts as broken
 * @param meshMillis least time between two snapshots of the mesh given to the listener while batches arrive; the base and the end of a round are always given
 */
public record SessionOptions(boolean serverPlan, int attempts, int backoffMillis, int stallMillis, int meshMillis) {
    public SessionOptions {
        if (attempts < 1) throw new IllegalArgumentException("attempts: " + attempts);
        if (backoffMillis < 0) throw new IllegalArgumentException("backoff in milliseconds: " + backoffMillis);
        if (stallMillis < 1) throw new IllegalArgumentException("stall in milliseconds: " + stallMillis);
        if (meshMillis < 0) throw new IllegalArgumentException("time between meshes in milliseconds: " + meshMillis);
    }

    /** The client plans; six attempts, the first after 250 ms; broken after 20 s of silence; a mesh at most every 150 ms. */
    public static SessionOptions defaults() {
        return new SessionOptions(false, 6, 250, 20_000, 150);
    }

    public SessionOptions withServerPlan(boolean on) {
        return new SessionOptions(on, attempts, backoffMillis, stallMillis, meshMillis);
    }

    public SessionOptions withAttempts(int count) {
        return new SessionOptions(serverPlan, count, backoffMillis, stallMillis, meshMillis);
    }

    public SessionOptions withBackoffMillis(int millis) {
        return new SessionOptions(serverPlan, attempts, millis, stallMillis, meshMillis);
    }

    public SessionOptions withStallMillis(int millis) {
        return new SessionOptions(serverPlan, attempts, backoffMillis, millis, meshMillis);
    }

    public SessionOptions withMeshMillis(int millis) {
        return new SessionOptions(serverPlan, attempts, backoffMillis, stallMillis, millis);
    }
}
