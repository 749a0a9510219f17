package org.jsmesh.app.server;

import java.nio.ByteBuffer;
import org.eclipse.jetty.http.MetaData;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.HttpStream;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.util.BufferUtil;
import org.eclipse.jetty.util.Callback;

/**
 * One request and its answer, as they pass on the way to the connection: what was asked for, and when how many bytes
 * went.
 */
final class Exchange extends HttpStream.Wrapper {
    /** Is told when an exchange is over. */
    interface Listener {
        void ended(Exchange exchange);
    }

    private final Request request;
    private final Peer peer;
    private final Client client;
    private final boolean admitted;
    private final Listener listener;
    private final long beginNanos;
    private final Sending sending = new Sending();
    private final StreamProgress pace = new StreamProgress();
    private volatile int status;
    private volatile long plannedBytes = -1;
    private volatile long firstByteNanos;
    private volatile long endNanos;
    private volatile boolean aborted;
    private long sentBytes;
    private volatile long sendingSinceNanos;
    private volatile long readingSinceNanos;
    private volatile long readBytes;

    /** @param admitted whether the client is within its limits, and is counted */
    Exchange(HttpStream stream, Request request, Peer peer, Client client, boolean admitted, Listener listener) {
        super(stream);
        this.request = request;
        this.peer = peer;
        this.client = client;
        this.admitted = admitted;
        this.listener = listener;
        beginNanos = request.getBeginNanoTime();
    }

    @Override
    public void send(
            MetaData.Request asked, MetaData.Response response, boolean last, ByteBuffer content, Callback callback) {
        long now = System.nanoTime();
        if (response != null && status == 0 && response.getStatus() >= 200) {
            status = response.getStatus();
            firstByteNanos = now;
            plannedBytes = request.getMethod().equals("HEAD") ? 0 : response.getContentLength();
        }
        sending.begin(callback, BufferUtil.length(content), now);
        super.send(asked, response, last, content, sending);
    }

    @Override
    public Content.Chunk read() {
        if (readingSinceNanos == 0) readingSinceNanos = System.nanoTime();
        Content.Chunk chunk = super.read();
        if (chunk != null) {
            long before = readBytes;
            readBytes = before + chunk.remaining();
            if (chunk.isLast()) readingSinceNanos = Long.MAX_VALUE;
        }
        return chunk;
    }

    @Override
    public void succeeded() {
        end(false);
        super.succeeded();
    }

    @Override
    public void failed(Throwable failure) {
        end(true);
        super.failed(failure);
    }

    private void end(boolean failed) {
        if (endNanos != 0) return;
        endNanos = System.nanoTime();
        // The application gives up quietly when the connection is gone.
        aborted = failed || sentBytes < plannedBytes;
        listener.ended(this);
    }

    Request request() {
        return request;
    }

    Peer peer() {
        return peer;
    }

    Client client() {
        return client;
    }

    boolean isAdmitted() {
        return admitted;
    }

    /** Of the answer; 0 when there was none. */
    int status() {
        return status;
    }

    /** Announced length of the content, -1 when there was none. */
    long plannedBytes() {
        return plannedBytes;
    }

    /** Bytes of content that the connection has taken. */
    long sentBytes() {
        return sentBytes;
    }

    /** Whether the answer ended before it was whole. */
    boolean isAborted() {
        return aborted;
    }

    /** From the first byte of the request to the first of the answer, or -1 when there was none. */
    long firstByteAfterNanos() {
        return status == 0 ? -1 : firstByteNanos - beginNanos;
    }

    long durationNanos() {
        return endNanos - beginNanos;
    }

    /** Since when the connection has been taking the same portion; 0 when it is not. */
    long sendingSinceNanos() {
        return sendingSinceNanos;
    }

    /** Only for the one thread that checks connections. */
    StreamProgress pace() {
        return pace;
    }

    /**
     * Whether the body of the request is being read and takes longer than {@code grantedMillis}, plus a second for
     * every so many bytes.
     */
    boolean isBodyLate(long now, long grantedMillis, int bytesPerSecond) {
        long since = readingSinceNanos;
        if (since == 0 || since == Long.MAX_VALUE) return false;
        return (now - since) / 1_000_000 > grantedMillis + readBytes * 1000 / bytesPerSecond;
    }

    /**
     * Is called when the connection has taken a portion. One object serves all portions, because they follow each
     * other.
     */
    private final class Sending implements Callback {
        private Callback pending;
        private int bytes;

        void begin(Callback callback, int length, long now) {
            pending = callback;
            bytes = length;
            sendingSinceNanos = now;
        }

        @Override
        public void succeeded() {
            sendingSinceNanos = 0;
            sentBytes += bytes;
            pending.succeeded();
        }

        @Override
        public void failed(Throwable failure) {
            sendingSinceNanos = 0;
            pending.failed(failure);
        }

        @Override
        public InvocationType getInvocationType() {
            return pending.getInvocationType();
        }
    }
}
