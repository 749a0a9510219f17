package org.jsmesh.app.server;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.StandardSocketOptions;
import java.nio.channels.SocketChannel;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.LongAdder;
import org.eclipse.jetty.http.HttpParser;
import org.eclipse.jetty.http2.ErrorCode;
import org.eclipse.jetty.http2.HTTP2Connection;
import org.eclipse.jetty.http2.HTTP2Session;
import org.eclipse.jetty.http2.HTTP2Stream;
import org.eclipse.jetty.io.Connection;
import org.eclipse.jetty.io.ssl.SslConnection;
import org.eclipse.jetty.server.internal.HttpConnection;
import org.eclipse.jetty.util.component.AbstractLifeCycle;

/**
 * Closes connections that clients keep open by being slow: by a header or a body that comes byte by byte, by hardly
 * reading an answer, or by sending nothing at all. An HTTP/2 connection may carry the requests of many clients, so only
 * its slow stream is reset as long as the others make progress. A timeout for idle connections does not catch any of
 * these, because there is always a byte in time.
 */
final class SlowConnectionGuard extends AbstractLifeCycle {
    private static final Logger LOG = System.getLogger(SlowConnectionGuard.class.getName());
    private static final int LOOKS_PER_DEADLINE = 4;
    private static final long LEAST_PERIOD_MILLIS = 20;
    private static final long LONGEST_PERIOD_MILLIS = 1000;
    private static final long NANOS = 1_000_000;
    private static final long FAREWELL_MILLIS = 5000;

    private final Limits limits;
    private final GuardedConnector connector;
    private final AdmissionHandler door;
    private final LongAdder dropped = new LongAdder();
    private ScheduledExecutorService timer;

    SlowConnectionGuard(Limits limits, GuardedConnector connector, AdmissionHandler door) {
        this.limits = limits;
        this.connector = connector;
        this.door = door;
    }

    /** Connections closed and HTTP/2 streams reset because they were slow. */
    long dropped() {
        return dropped.sum();
    }

    @Override
    protected void doStart() {
        timer = Executors.newSingleThreadScheduledExecutor(task -> {
            Thread thread = new Thread(task, "jsm-watchman");
            thread.setDaemon(true);
            return thread;
        });
        long shortest = Math.min(
                Math.min(limits.headerMillis(), limits.bodyMillis()),
                Math.min(limits.stallMillis(), limits.idleMillis()));
        long period = Math.max(LEAST_PERIOD_MILLIS, Math.min(LONGEST_PERIOD_MILLIS, shortest / LOOKS_PER_DEADLINE));
        timer.scheduleWithFixedDelay(this::look, period, period, TimeUnit.MILLISECONDS);
    }

    @Override
    protected void doStop() {
        timer.shutdownNow();
    }

    private void look() {
        long now = System.nanoTime();
        Map<Peer, Integer> sending = new HashMap<>();
        for (Exchange exchange : door.running()) {
            if (exchange.sendingSinceNanos() != 0) sending.merge(exchange.peer(), 1, Integer::sum);
        }
        for (Peer peer : connector.peers()) guard(() -> look(peer, sending.containsKey(peer), now));
        for (Exchange exchange : door.running())
            guard(() -> look(exchange, sending.getOrDefault(exchange.peer(), 1), now));
    }

    /**
     * The executor never runs a task again that has failed once, and one connection must not keep the others from being
     * checked.
     */
    private static void guard(Runnable task) {
        try {
            task.run();
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, "A connection cannot be watched", e);
        }
    }

    private void look(Peer peer, boolean sending, long now) {
        Connection connection = connection(peer);
        String reason = reason(peer, now);
        if (reason != null) drop(peer, reason);
        else if (connector.isShutdown() && isIdle(peer)) sayFarewell(peer, connection, now);
        else if (connection instanceof HTTP2Connection http2)
            peer.watch(sending, http2.getSession().getBytesWritten(), now);
    }

    /**
     * In HTTP/2 the client closes when it is told to. One that does not must not hold a server that stops; but it is
     * given time, because what it has not read yet is lost when it grants more to a connection that is closed.
     */
    private static void sayFarewell(Peer peer, Connection connection, long now) {
        if (peer.farewellNanos == 0) {
            peer.farewellNanos = now;
            connection.close();
        } else if (now - peer.farewellNanos > FAREWELL_MILLIS * NANOS) {
            peer.endPoint().close();
        }
    }

    private void look(Exchange exchange, int sharing, long now) {
        boolean late = exchange.isBodyLate(now, limits.bodyMillis(), Limits.LEAST_BYTES_PER_SECOND);
        long since = exchange.sendingSinceNanos();
        Peer peer = exchange.peer();
        if (connection(peer) instanceof HTTP2Connection http2) {
            if (since != 0) exchange.pace().look(since, now, sharing);
            look(exchange, http2.getSession(), late, since != 0, now);
        } else if (since != 0 && isStall(now - since)) drop(peer, "it does not read");
        else if (late) drop(peer, "its body does not end");
    }

    private void look(Exchange exchange, HTTP2Session session, boolean late, boolean sending, long now) {
        StreamProgress pace = exchange.pace();
        Peer peer = exchange.peer();
        HTTP2Stream stream = session.getStream(Integer.parseInt(exchange.getId()));
        if (pace.resetNanos() != 0) {
            // The connection does not even take the reset.
            if (isStall(now - pace.resetNanos())) drop(peer, "it does not read");
        } else if (late) {
            reset(session, exchange, now);
        } else if (sending && isStall(pace.spentNanos())) {
            reset(session, exchange, now);
        } else if (sending && isStall(now - pace.sinceNanos()) && isStall(now - peer.movedNanos())) {
            // No stream makes progress. If only the stream's own window is full, others may still make progress.
            if (stream != null && stream.getSendWindow() <= 0) reset(session, exchange, now);
            else drop(peer, "it does not read");
        }
    }

    private boolean isStall(long nanos) {
        return nanos > limits.stallMillis() * NANOS;
    }

    private void reset(HTTP2Session session, Exchange exchange, long now) {
        exchange.pace().reset(now);
        dropped.increment();
        session.onStreamFailure(
                Integer.parseInt(exchange.getId()), ErrorCode.CANCEL_STREAM_ERROR.code, "the client is too slow");
    }

    private void drop(Peer peer, String reason) {
        // Its requests may take a while to notice.
        if (!peer.isDropped) dropped.increment();
        peer.isDropped = true;
        forget(peer);
        peer.endPoint().close(new TimeoutException("the client is too slow: " + reason));
    }

    /** Lets the kernel throw away what the reader has not taken, instead of keeping megabytes for it. */
    private static void forget(Peer peer) {
        if (!(peer.endPoint().getTransport() instanceof SocketChannel socket)) return;
        try {
            socket.setOption(StandardSocketOptions.SO_LINGER, 0);
        } catch (IOException e) {
            // Gone already.
        }
    }

    private static Connection connection(Peer peer) {
        Connection connection = peer.endPoint().getConnection();
        return connection instanceof SslConnection tls ? tls.getSslEndPoint().getConnection() : connection;
    }

    /** Nobody would close it while the server waits for the last transfers. */
    private static boolean isIdle(Peer peer) {
        Connection connection = connection(peer);
        if (connection instanceof HttpConnection http) return http.getParser().isStart();
        return connection instanceof HTTP2Connection http2 && http2.getSession().getStreamCount() == 0;
    }

    /** Reason to close the connection, or null. */
    private String reason(Peer peer, long now) {
        boolean old = now - peer.openedNanos() > limits.headerMillis() * NANOS;
        Connection connection = connection(peer);
        if (connection instanceof HttpConnection http) return reason(http, old, now);
        if (connection instanceof HTTP2Connection http2) return reason(peer, http2.getSession(), old, now);
        return old ? "it has not agreed on a protocol" : null;
    }

    private String reason(HttpConnection connection, boolean old, long now) {
        HttpParser parser = connection.getParser();
        if (parser.isStart()) return old && connection.getMessagesIn() == 0 ? "it asks nothing" : null;
        long begin = parser.getBeginNanoTime();
        long spent = begin == 0 ? 0 : (now - begin) / NANOS;
        if (parser.inHeaderState()) return spent > limits.headerMillis() ? "its header does not end" : null;
        if (!parser.inContentState()) return null;
        long granted = limits.headerMillis()
                + limits.bodyMillis()
                + parser.getContentRead() * 1000 / Limits.LEAST_BYTES_PER_SECOND;
        return spent > granted ? "its body does not end" : null;
    }

    private String reason(Peer peer, HTTP2Session session, boolean old, long now) {
        if (session.getStreamsOpened() == 0) return old ? "it asks nothing" : null;
        if (session.getStreamCount() > 0) {
            peer.idleNanos = 0;
            return null;
        }
        // Pings and other frames without a stream keep no connection open.
        if (peer.idleNanos == 0) peer.idleNanos = now;
        return now - peer.idleNanos > limits.idleMillis() * NANOS ? "it asks nothing more" : null;
    }
}
