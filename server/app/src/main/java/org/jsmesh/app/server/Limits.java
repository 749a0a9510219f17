package org.jsmesh.app.server;

/**
 * The limits for the clients of a server, so that none of them keeps the others from being served.
 *
 * @param connections open at the same time; requests on those beyond are answered by 503
 * @param connectionsPerAddress of one client address; those beyond are closed
 * @param requestsPerAddress being answered at the same time; those beyond are answered by 503
 * @param requestsPerSecond of one client address in the long run; those beyond are answered by 429; 0 for no limit
 * @param requestBurst requests of one client address that may come at once
 * @param headerBytes of one request's target and fields together
 * @param headerMillis from a request's first byte to the end of its header, and from a connection's begin to its first
 *     request
 * @param bodyMillis that a request's body may take besides one second for every {@link #LEAST_BYTES_PER_SECOND}
 * @param stallMillis in which a reader must take {@link #PORTION_BYTES}, or what is left
 * @param idleMillis without a request or a byte
 */
public record Limits(
        int connections,
        int connectionsPerAddress,
        int requestsPerAddress,
        int requestsPerSecond,
        int requestBurst,
        int headerBytes,
        long headerMillis,
        long bodyMillis,
        long stallMillis,
        long idleMillis) {
    /** A slower upload would never end. */
    static final int LEAST_BYTES_PER_SECOND = 1000;

    /** Bytes that show that a reader reads: a modem takes so many within the default of {@code stallMillis}. */
    static final int PORTION_BYTES = 1 << 18;

    public Limits {
        atLeast(1, connections, "max-connections");
        atLeast(1, connectionsPerAddress, "max-connections-per-address");
        atLeast(1, requestsPerAddress, "max-requests-per-address");
        atLeast(0, requestsPerSecond, "max-request-rate");
        atLeast(1, requestBurst, "request-burst");
        atLeast(512, headerBytes, "max-header-bytes");
    }

    private static void atLeast(int least, int value, String option) {
        if (value < least)
            throw new IllegalArgumentException("--" + option + " is " + value + "; it must be at least " + least);
    }

    public static Limits defaults() {
        // The default idle time is as long as people look at a model between two rounds on one connection.
        // Five hundred viewers behind one address ask two hundred times a second, and all at once after a restart.
        return new Limits(8192, 1024, 1024, 1000, 2000, 8192, 10_000, 10_000, 120_000, 120_000);
    }

    public Limits withConnections(int most, int mostPerAddress) {
        return new Limits(
                most,
                mostPerAddress,
                requestsPerAddress,
                requestsPerSecond,
                requestBurst,
                headerBytes,
                headerMillis,
                bodyMillis,
                stallMillis,
                idleMillis);
    }

    public Limits withRequestsPerAddress(int most) {
        return new Limits(
                connections,
                connectionsPerAddress,
                most,
                requestsPerSecond,
                requestBurst,
                headerBytes,
                headerMillis,
                bodyMillis,
                stallMillis,
                idleMillis);
    }

    public Limits withRequestRate(int perSecond, int burst) {
        return new Limits(
                connections,
                connectionsPerAddress,
                requestsPerAddress,
                perSecond,
                burst,
                headerBytes,
                headerMillis,
                bodyMillis,
                stallMillis,
                idleMillis);
    }

    public Limits withHeaderBytes(int most) {
        return new Limits(
                connections,
                connectionsPerAddress,
                requestsPerAddress,
                requestsPerSecond,
                requestBurst,
                most,
                headerMillis,
                bodyMillis,
                stallMillis,
                idleMillis);
    }

    public Limits withMillis(long header, long body, long stall, long idle) {
        return new Limits(
                connections,
                connectionsPerAddress,
                requestsPerAddress,
                requestsPerSecond,
                requestBurst,
                headerBytes,
                header,
                body,
                stall,
                idle);
    }
}
