package org.jsmesh.load;

import java.net.SocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/** Which trouble is the test's own: what the proxy did to connections, and when the server was away. Thread-safe. */
final class InjectedFaults {
    private final Map<SocketAddress, Double> untilMillis = new ConcurrentHashMap<>();
    private final List<double[]> outages = new ArrayList<>();
    final AtomicLong proxyCuts = new AtomicLong();
    final AtomicLong proxyStalls = new AtomicLong();
    final AtomicLong viewerCuts = new AtomicLong();
    final AtomicLong viewerResets = new AtomicLong();
    final AtomicLong viewerStalls = new AtomicLong();

    /** A connection is, or was, out of order. */
    void mark(SocketAddress viewer, double until) {
        untilMillis.merge(viewer, until, Math::max);
    }

    void forget(SocketAddress viewer) {
        untilMillis.remove(viewer);
    }

    /** When the last fault of a connection ends; infinite after a cut, minus infinity without any. */
    double untilMillis(SocketAddress viewer) {
        return untilMillis.getOrDefault(viewer, Double.NEGATIVE_INFINITY);
    }

    synchronized void outageBegins(double now) {
        outages.add(new double[] {now, Double.POSITIVE_INFINITY});
    }

    synchronized void outageEnds(double now) {
        outages.get(outages.size() - 1)[1] = now;
    }

    /** Whether the server was away at any time between. */
    synchronized boolean isOutage(double fromMillis, double toMillis) {
        for (double[] outage : outages) if (outage[0] <= toMillis && fromMillis <= outage[1]) return true;
        return false;
    }

    /**
     * Whether the test itself may have broken a connection.
     *
     * @param viewer the viewer's end of the connection, or null when there was none
     * @param signMillis when the connection last gave a sign
     * @param stallMillis the silence that counts as a break
     */
    boolean explain(SocketAddress viewer, double signMillis, double nowMillis, double stallMillis) {
        return viewer != null && untilMillis(viewer) > nowMillis - 2 * stallMillis
                || isOutage(Math.min(signMillis, nowMillis - 1000), nowMillis);
    }

    /** Seconds that each outage took. */
    synchronized List<Double> outageSeconds() {
        return outages.stream().map(o -> (o[1] - o[0]) / 1000).toList();
    }
}
