package org.jsmesh.load;

import java.io.IOException;
import java.util.function.BooleanSupplier;
import org.jsmesh.load.net.EventLoop;
import org.jsmesh.load.net.Link;
import org.jsmesh.load.net.ViewerConnection;

/**
 * The connection of a viewer, of either protocol. It is made anew when it is gone, and watched: silence counts as a
 * break. Used on its loop alone.
 */
final class ViewerLine {
    /** A connection that delivers nothing for so long counts as broken. */
    private static final double STALL_MILLIS = 6000;

    private final ViewerProfile profile;
    private final LoadRun run;
    private final Link link;
    private final ViewerConnection.Listener viewer;
    private ViewerConnection connection;
    private double lastSignMillis;

    ViewerLine(ViewerProfile profile, LoadRun run, Link link, ViewerConnection.Listener viewer) {
        this.profile = profile;
        this.run = run;
        this.link = link;
        this.viewer = viewer;
    }

    /**
     * Sends a request. The viewer is told when it cannot be sent.
     *
     * @param waiting whether the answer is still waited for
     */
    void send(ViewerRequest request, BooleanSupplier waiting) {
        lastSignMillis = EventLoop.millis();
        try {
            if (connection == null || connection.isClosed()) connection = run.connect(profile, link, viewer);
            connection.send(request.head(run.address(profile)));
        } catch (IOException e) {
            viewer.onBroken("cannot connect: " + e.getMessage());
            return;
        }
        watch(waiting);
    }

    private void watch(BooleanSupplier waiting) {
        run.loop().at(lastSignMillis + STALL_MILLIS, () -> {
            if (!waiting.getAsBoolean()) return;
            double silent = EventLoop.millis() - lastSignMillis;
            if (silent < STALL_MILLIS) {
                watch(waiting);
                return;
            }
            run.tally().stallsTimedOut++;
            connection.close();
            viewer.onBroken("nothing came for " + (long) silent + " ms");
        });
    }

    /** Something came. */
    void sign(double nowMillis) {
        lastSignMillis = nowMillis;
    }

    /** Whether the test itself may have broken the connection. */
    boolean isExplained(double nowMillis) {
        return link.blockedUntilMillis() > nowMillis - STALL_MILLIS
                || run.faults()
                        .explain(
                                connection == null ? null : connection.address(),
                                lastSignMillis,
                                nowMillis,
                                STALL_MILLIS);
    }

    /** Whether the proxy had it in hand at that time or later. */
    boolean wasFaulty(double sinceMillis) {
        return connection != null && run.faults().untilMillis(connection.address()) >= sinceMillis;
    }

    /** The viewer's own fault. */
    void cut() {
        run.faults().viewerCuts.incrementAndGet();
        run.faults().mark(connection.address(), Double.POSITIVE_INFINITY);
        connection.close();
    }

    /** Gives up the request under way, with the connection where the protocol knows no other way. */
    void giveUp() {
        connection.cancel();
        if (connection.isClosed()) lost();
    }

    /** The connection is no more. */
    void lost() {
        if (connection != null) run.faults().forget(connection.address());
        connection = null;
    }

    void close() {
        if (connection != null) connection.close();
        lost();
    }
}
