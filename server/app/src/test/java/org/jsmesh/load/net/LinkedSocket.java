package org.jsmesh.load.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Queue;

/** A socket that is read as fast as its {@link Link} allows. Used on its loop alone. */
public final class LinkedSocket {
    private final EventLoop loop;
    private final Link link;
    private final Listener listener;
    private final SocketChannel channel;
    private final SelectionKey key;
    private final SocketAddress address;
    private final Queue<ByteBuffer> outgoing = new ArrayDeque<>();
    private double lastSendMillis = Double.NEGATIVE_INFINITY;
    private EventLoop.Timer reading;
    private boolean closed;

    /** What arrives. After {@link #onBroken} nothing more does. */
    public interface Listener {
        /** Bytes, which are all to be taken, unless the socket is closed meanwhile. */
        void onBytes(ByteBuffer bytes);

        void onBroken(String why);
    }

    /**
     * Starts to connect.
     *
     * @param source the viewer's own address
     * @throws IOException when that is refused at once
     */
    public LinkedSocket(EventLoop loop, InetAddress source, InetSocketAddress target, Link link, Listener listener)
            throws IOException {
        this.loop = loop;
        this.link = link;
        this.listener = listener;
        channel = SocketChannel.open();
        try {
            channel.configureBlocking(false);
            channel.setOption(StandardSocketOptions.SO_RCVBUF, link.bufferBytes());
            channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
            channel.bind(new InetSocketAddress(source, 0));
            address = channel.getLocalAddress();
            boolean connected = channel.connect(target);
            key = loop.register(channel, connected ? 0 : SelectionKey.OP_CONNECT, k -> ready());
        } catch (IOException e) {
            EventLoop.closeQuietly(channel);
            throw e;
        }
    }

    /** This end. */
    public SocketAddress address() {
        return address;
    }

    /**
     * Sends bytes after a round trip, the way back of the answer included; two of them for the first bytes, as the
     * connection has to be made.
     */
    public void send(ByteBuffer bytes) {
        double trips = lastSendMillis == Double.NEGATIVE_INFINITY ? 2 : 1;
        lastSendMillis = Math.max(lastSendMillis, EventLoop.millis() + trips * link.roundTripMillis());
        loop.at(lastSendMillis, () -> {
            if (closed) return;
            outgoing.add(bytes);
            want(SelectionKey.OP_READ);
            if (channel.isConnected()) write();
        });
    }

    public void close() {
        closed = true;
        if (reading != null) reading.cancel();
        EventLoop.closeQuietly(channel);
    }

    public boolean isClosed() {
        return closed;
    }

    private void ready() {
        if (closed) return;
        if (key.isConnectable()) connect();
        if (!closed && key.isWritable()) write();
        if (!closed && key.isReadable()) read();
    }

    private void connect() {
        try {
            if (!channel.finishConnect()) return;
            unwant(SelectionKey.OP_CONNECT);
            want(SelectionKey.OP_READ);
            write();
        } catch (IOException e) {
            broken("cannot connect: " + e.getMessage());
        }
    }

    private void write() {
        try {
            for (ByteBuffer bytes; (bytes = outgoing.peek()) != null; outgoing.remove()) {
                channel.write(bytes);
                if (bytes.hasRemaining()) {
                    want(SelectionKey.OP_WRITE);
                    return;
                }
            }
            unwant(SelectionKey.OP_WRITE);
        } catch (IOException e) {
            broken("cannot send: " + e.getMessage());
        }
    }

    private void read() {
        double now = EventLoop.millis();
        int allowed = link.allowance(now);
        if (allowed == 0) {
            unwant(SelectionKey.OP_READ);
            if (reading != null) reading.cancel();
            reading = loop.at(link.readyMillis(), () -> {
                reading = null;
                if (!closed) read();
            });
            return;
        }
        ByteBuffer buffer = loop.buffer();
        buffer.limit(Math.min(buffer.capacity(), allowed));
        int wanted = buffer.remaining();
        int n;
        try {
            n = channel.read(buffer);
        } catch (IOException e) {
            broken("broke: " + e.getMessage());
            return;
        }
        if (n < 0) {
            broken("closed by the other end");
            return;
        }
        link.took(n, n < wanted);
        want(SelectionKey.OP_READ);
        if (n > 0) listener.onBytes(buffer.flip());
    }

    private void broken(String why) {
        close();
        listener.onBroken(why);
    }

    private void want(int operation) {
        if (!closed) key.interestOpsOr(operation);
    }

    private void unwant(int operation) {
        if (!closed) key.interestOpsAnd(~operation);
    }
}
