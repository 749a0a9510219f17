package org.jsmesh.simulation;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/**
 * A server, a link and a client's kernel in virtual time, for one response after the other. It models TCP with
 * handshake, slow start, a bottleneck whose buffer overflows, and the fate of bytes on their way when a response is
 * given up.
 *
 * <p>The server writes into its kernel's buffer, which holds twice the congestion window (as Linux tunes it). Packets
 * wait in the bottleneck's buffer and leave it at the rate of the link. A packet that finds the buffer full is lost,
 * and the window shrinks to .7 of what it was. Closing an HTTP/1.1 connection discards the server's buffer half a round
 * trip later; resetting a stream of HTTP/2 does not. Headers of packets are not counted.
 */
final class VirtualLink {
    private static final int PACKET_BYTES = 1448;
    private static final double FIRST_WINDOW_BYTES = 10 * PACKET_BYTES;
    private static final int LEAST_BUFFER_BYTES = 16 * PACKET_BYTES;
    private static final double QUEUE_MILLIS = 200;
    private static final int LEAST_SOCKET_BUFFER_BYTES = 46_080;
    private static final double LOSS_FACTOR = .7;
    /** A sender that was idle for so long may not begin with its old window. */
    private static final double IDLE_MILLIS = 300;

    private final DoubleUnaryOperator bitsPerSecondAt;
    private final HttpVersion version;
    private final double roundTripMillis;
    private final double serverMillis;
    private final double queueBytes;
    private final int packetBytes;
    private final double stepMillis;

    private final ArrayDeque<Packet> queue = new ArrayDeque<>();
    private final ArrayDeque<Packet> crossing = new ArrayDeque<>();
    private final ArrayDeque<Packet> acknowledged = new ArrayDeque<>();
    private double queued;
    private double service;
    private double now;

    private final List<Connection> connections = new ArrayList<>();
    private Connection connection;
    private Response response;
    private long wastedBytes;

    private static final class Packet {
        final Response of;
        final int bytes;
        double atMillis;

        Packet(Response of, int bytes) {
            this.of = of;
            this.bytes = bytes;
        }
    }

    private static final class Connection {
        double window = FIRST_WINDOW_BYTES;
        double threshold = Double.MAX_VALUE;
        double inFlight;
        /** Whether the window has held packets back since the connection last rested; it grows only then. */
        boolean limited;

        double lastLossMillis = Double.NEGATIVE_INFINITY;
        double lastSentMillis;
        double closedMillis = Double.POSITIVE_INFINITY;
        /** Responses whose bytes are in the server's buffer; only the last may still grow. */
        final ArrayDeque<Response> sending = new ArrayDeque<>();
    }

    private static final class Response {
        final Connection on;
        final double beginMillis;
        long unwritten;
        double buffered;
        int head;
        double resetMillis = Double.POSITIVE_INFINITY;
        boolean abandoned;
        long arrived;
        final long bytes;

        Response(Connection on, double beginMillis, int head, long bytes) {
            this.on = on;
            this.beginMillis = beginMillis;
            this.head = head;
            this.bytes = bytes;
            unwritten = head + bytes;
        }
    }

    /**
     * @param bitsPerSecondAt of the link over time in milliseconds
     * @param meanBitsPerSecond rate for which the buffer is made: it holds 200 ms of it, or 16 packets
     * @param roundTripMillis of an idle link
     * @param serverMillis from a request's arrival to the first byte of its response
     */
    VirtualLink(
            DoubleUnaryOperator bitsPerSecondAt,
            double meanBitsPerSecond,
            HttpVersion version,
            double roundTripMillis,
            double serverMillis) {
        this.bitsPerSecondAt = bitsPerSecondAt;
        this.version = version;
        this.roundTripMillis = roundTripMillis;
        this.serverMillis = serverMillis;
        queueBytes = Math.max(LEAST_BUFFER_BYTES, QUEUE_MILLIS * meanBitsPerSecond / 8000);
        // On a fast link packets travel in bunches, which saves time here and changes little.
        packetBytes = (int) Math.max(PACKET_BYTES, Math.min(meanBitsPerSecond / 8000 / 4, 1 << 24));
        stepMillis = meanBitsPerSecond < 128e3 ? 5 : 1;
    }

    double now() {
        return now;
    }

    /** Bytes that crossed the link for nobody. */
    long wastedBytes() {
        return wastedBytes;
    }

    boolean isBusy() {
        return response != null;
    }

    /** Bytes of the response under way that have not arrived. */
    long bytesLeft() {
        return response.bytes - response.arrived;
    }

    /** Sends a request. */
    void ask(long bytes) {
        double handshake = 0;
        if (connection == null) {
            connection = new Connection();
            connections.add(connection);
            handshake = roundTripMillis;
        } else if (connection.inFlight == 0) {
            rest(connection);
        }
        double begin = now + handshake + roundTripMillis / 2 + serverMillis;
        response = new Response(connection, begin, version.headBytes, bytes);
        connection.sending.add(response);
    }

    private void rest(Connection c) {
        c.limited = false;
        int periods = (int) Math.min((now - c.lastSentMillis) / IDLE_MILLIS, 60);
        for (int i = 0; i < periods && c.window > FIRST_WINDOW_BYTES; i++)
            c.window = Math.max(FIRST_WINDOW_BYTES, c.window / 2);
    }

    /** Gives the response under way up. */
    void cancel() {
        response.abandoned = true;
        if (version == HttpVersion.HTTP_1_1) {
            connection.closedMillis = now + roundTripMillis / 2;
            connection = null;
        } else {
            response.resetMillis = now + roundTripMillis / 2;
        }
        response = null;
    }

    /**
     * Lets a little time pass.
     *
     * @return bytes of the body that arrived; the response is over when none are left
     */
    long advance() {
        now += stepMillis;
        // A closed connection sends on until its server knows.
        for (int i = connections.size() - 1; i >= 0; i--) {
            if (now < connections.get(i).closedMillis) send(connections.get(i));
            else connections.remove(i);
        }
        serve();
        long before = response == null ? 0 : response.arrived;
        arrive();
        long arrived = response == null ? 0 : response.arrived - before;
        acknowledge();
        if (response != null && response.arrived == response.bytes) response = null;
        return arrived;
    }

    private void send(Connection c) {
        while (!c.sending.isEmpty()) {
            Response r = c.sending.peek();
            if (now < r.beginMillis) return;
            write(c, r);
            if (r.buffered == 0) {
                c.sending.remove();
                continue;
            }
            int bytes = (int) Math.min(packetBytes, r.buffered);
            if (c.inFlight + bytes > Math.max(c.window, packetBytes)) {
                c.limited = true;
                return;
            }
            if (queued + bytes > Math.max(queueBytes, packetBytes)) {
                lose(c);
                return;
            }
            r.buffered -= bytes;
            c.inFlight += bytes;
            c.lastSentMillis = now;
            queued += bytes;
            queue.add(new Packet(r, bytes));
        }
    }

    /** The server fills its kernel's buffer. */
    private void write(Connection c, Response r) {
        if (now >= r.resetMillis) r.unwritten = 0;
        double space = Math.max(Math.max(LEAST_SOCKET_BUFFER_BYTES, 2 * c.window), packetBytes) - r.buffered;
        long bytes = (long) Math.min(r.unwritten, Math.max(0, space));
        r.unwritten -= bytes;
        r.buffered += bytes;
    }

    private void lose(Connection c) {
        if (now < c.lastLossMillis + roundTripMillis) return;
        c.lastLossMillis = now + queued * 8000 / Math.max(1, bitsPerSecondAt.applyAsDouble(now));
        c.window = Math.max(2 * PACKET_BYTES, c.window * LOSS_FACTOR);
        c.threshold = c.window;
    }

    private void serve() {
        service += bitsPerSecondAt.applyAsDouble(now) / 8000 * stepMillis;
        while (!queue.isEmpty() && service >= queue.peek().bytes) {
            Packet p = queue.remove();
            service -= p.bytes;
            queued -= p.bytes;
            p.atMillis = now + roundTripMillis / 2;
            crossing.add(p);
        }
        if (queue.isEmpty()) service = Math.min(service, bitsPerSecondAt.applyAsDouble(now) / 8000 * stepMillis);
    }

    private void arrive() {
        while (!crossing.isEmpty() && crossing.peek().atMillis <= now) {
            Packet p = crossing.remove();
            int head = Math.min(p.of.head, p.bytes);
            p.of.head -= head;
            if (p.of.abandoned) wastedBytes += p.bytes - head;
            else p.of.arrived += p.bytes - head;
            p.atMillis += roundTripMillis / 2;
            acknowledged.add(p);
        }
    }

    private void acknowledge() {
        while (!acknowledged.isEmpty() && acknowledged.peek().atMillis <= now) {
            Packet p = acknowledged.remove();
            Connection c = p.of.on;
            c.inFlight -= p.bytes;
            if (c.limited) c.window += c.window < c.threshold ? p.bytes : (double) PACKET_BYTES * p.bytes / c.window;
        }
    }

    /**
     * Body bytes that a client gets between two times if it knows the course of the link: it makes one request for all
     * that fits, and for not a byte more. This leaves the connection open and nothing on its way, for the next call.
     */
    long mostBytes(double fromMillis, double toMillis) {
        while (now < fromMillis) advance();
        ask(Long.MAX_VALUE / 4);
        long bytes = 0;
        while (now < toMillis) bytes += advance();
        response = null;
        queue.clear();
        crossing.clear();
        acknowledged.clear();
        queued = 0;
        connection.inFlight = 0;
        connection.sending.clear();
        return bytes;
    }
}
