package org.jsmesh.load.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;

/**
 * A connection of one viewer, HTTP/1.1 with one request at a time, read as fast as its {@link Link} allows. Used on its
 * loop alone.
 */
public final class HttpConnection {
    private final EventLoop loop;
    private final Link link;
    private final Listener listener;
    private final SocketChannel channel;
    private final SelectionKey key;
    private final SocketAddress address;
    private ByteBuffer request;
    private ResponseHead head;
    private long bodyLeft;
    private boolean inBody;
    private boolean used;
    private EventLoop.Timer reading;
    private boolean closed;

    /** What arrives. After {@link #onBroken} nothing more does. */
    public interface Listener {
        void onHead(ResponseHead head);

        /** Bytes of the body; whoever does not take them all skips them. */
        void onBody(ByteBuffer bytes);

        void onEnd(ResponseHead head);

        /** The connection is no more; also told when no request was under way. */
        void onBroken(String why);
    }

    /**
     * Starts to connect.
     *
     * @param source the viewer's own address
     * @throws IOException when that is refused at once
     */
    public HttpConnection(EventLoop loop, InetAddress source, InetSocketAddress target, Link link, Listener listener)
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

    /** The viewer's end, by which a proxy knows the connection. */
    public SocketAddress address() {
        return address;
    }

    /** Sends a request after a round trip; one more for the first, as the connection has to be made. */
    public void send(String text) {
        if (request != null || head != null) throw new IllegalStateException("a request is under way");
        ByteBuffer bytes = ByteBuffer.wrap(ResponseHead.bytes(text));
        head = new ResponseHead();
        inBody = false;
        double delay = used ? link.roundTripMillis() : 2 * link.roundTripMillis();
        used = true;
        loop.at(EventLoop.millis() + delay, () -> {
            if (closed) return;
            request = bytes;
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
            if (request != null) write();
        } catch (IOException e) {
            broken("cannot connect: " + e.getMessage());
        }
    }

    private void write() {
        try {
            if (request != null) channel.write(request);
        } catch (IOException e) {
            broken("cannot send: " + e.getMessage());
            return;
        }
        if (request != null && request.hasRemaining()) {
            want(SelectionKey.OP_WRITE);
        } else {
            request = null;
            unwant(SelectionKey.OP_WRITE);
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
        buffer.flip();
        while (!closed && buffer.hasRemaining()) take(buffer);
    }

    private void take(ByteBuffer buffer) {
        if (head == null) {
            broken("bytes that nobody asked for");
            return;
        }
        if (!inBody) {
            if (!head.read(buffer)) return;
            if (head.status() / 100 == 1) {
                head = new ResponseHead();
                return;
            }
            inBody = true;
            bodyLeft = head.length();
            if (bodyLeft < 0) {
                broken("an answer without a length, status " + head.status());
                return;
            }
            listener.onHead(head);
        } else {
            int n = (int) Math.min(bodyLeft, buffer.remaining());
            ByteBuffer body = buffer.slice(buffer.position(), n);
            buffer.position(buffer.position() + n);
            bodyLeft -= n;
            listener.onBody(body);
        }
        if (!closed && bodyLeft == 0) {
            ResponseHead done = head;
            head = null;
            if (done.isLast()) close();
            listener.onEnd(done);
        }
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
