package org.jsmesh.load.net;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.nio.ByteBuffer;

/** HTTP/1.1, without requests ahead of their time. A request is given up with its connection. */
public final class Http1Connection implements ViewerConnection {
    private final Listener listener;
    private final LinkedSocket socket;
    private ResponseHead head;
    private long bodyLeft;
    private boolean inBody;

    /**
     * Starts to connect.
     *
     * @param source the viewer's own address
     * @throws IOException when that is refused at once
     */
    public Http1Connection(EventLoop loop, InetAddress source, InetSocketAddress target, Link link, Listener listener)
            throws IOException {
        this.listener = listener;
        socket = new LinkedSocket(loop, source, target, link, new LinkedSocket.Listener() {
            @Override
            public void onBytes(ByteBuffer bytes) {
                while (!isClosed() && bytes.hasRemaining()) take(bytes);
            }

            @Override
            public void onBroken(String why) {
                listener.onBroken(why);
            }
        });
    }

    @Override
    public SocketAddress address() {
        return socket.address();
    }

    @Override
    public void send(RequestHead request) {
        if (head != null) throw new IllegalStateException("a request is under way");
        head = new ResponseHead();
        inBody = false;
        socket.send(ByteBuffer.wrap(request.http1()));
    }

    @Override
    public void cancel() {
        close();
    }

    @Override
    public void close() {
        socket.close();
    }

    @Override
    public boolean isClosed() {
        return socket.isClosed();
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
        if (!isClosed() && bodyLeft == 0) {
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
}
