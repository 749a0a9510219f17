package org.jsmesh.session.link;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A TCP proxy on 127.0.0.1 with a limited rate towards the client, and a delay, whatever is spoken through it. All its
 * connections share one link. Thread-safe.
 */
public final class ShapingPipe implements AutoCloseable {
    private static final int BUFFER_BYTES = 16384;
    private final ServerSocket listener;
    private final InetSocketAddress target;
    private final ShapedLink link = new ShapedLink();
    private final AtomicLong carried = new AtomicLong();
    private final AtomicLong connections = new AtomicLong();
    private final Queue<Socket> sockets = new ConcurrentLinkedQueue<>();
    private volatile OutputStream copy = OutputStream.nullOutputStream();
    private volatile boolean closed;

    private ShapingPipe(InetSocketAddress target) throws IOException {
        this.target = target;
        listener = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        start("pipe-accept", this::accept);
    }

    /** A pipe to the server of an address. */
    public static ShapingPipe to(URI server) throws IOException {
        return new ShapingPipe(new InetSocketAddress(InetAddress.getLoopbackAddress(), server.getPort()));
    }

    /** The rate towards the client from now on, all connections together. */
    public ShapingPipe bytesPerSecond(double rate) {
        link.setBytesPerSecond(rate);
        return this;
    }

    /** The time of a round trip from now on: what clients send, and a new connection, is held back for as long. */
    public ShapingPipe delayMillis(long millis) {
        link.setDelayMillis(millis);
        return this;
    }

    /** The time that a busy machine may lose and catch up again. After a pause, as much passes at once. */
    public ShapingPipe burstMillis(long millis) {
        link.setBurstMillis(millis);
        return this;
    }

    /** Where a copy of what goes to clients is written from now on. */
    public ShapingPipe copyTo(OutputStream out) {
        copy = out;
        return this;
    }

    /** Breaks all connections that there are. */
    public void cut() throws IOException {
        for (Socket s; (s = sockets.poll()) != null; ) s.close();
    }

    /** The same address through this pipe. */
    public URI through(URI address) {
        return URI.create(address.getScheme() + "://127.0.0.1:" + listener.getLocalPort() + address.getRawPath()
                + (address.getRawQuery() == null ? "" : "?" + address.getRawQuery()));
    }

    /** Bytes that went to clients so far, encryption and heads included. */
    public long carriedBytes() {
        return carried.get();
    }

    /** Connections so far. */
    public long connections() {
        return connections.get();
    }

    @Override
    public void close() throws IOException {
        closed = true;
        listener.close();
        cut();
    }

    private void accept() throws IOException {
        while (!closed) {
            Socket client = listener.accept();
            Socket server = new Socket();
            sockets.add(client);
            sockets.add(server);
            connections.incrementAndGet();
            client.setTcpNoDelay(true);
            client.setSendBufferSize(BUFFER_BYTES);
            server.setTcpNoDelay(true);
            server.setReceiveBufferSize(BUFFER_BYTES);
            server.connect(target);
            start("pipe-up", () -> {
                try (client;
                        server) {
                    up(client.getInputStream(), server.getOutputStream());
                }
            });
            start("pipe-down", () -> {
                try (client;
                        server) {
                    down(server.getInputStream(), client.getOutputStream());
                }
            });
        }
    }

    private void up(InputStream in, OutputStream out) throws IOException {
        byte[] buffer = new byte[BUFFER_BYTES];
        link.delay(); // the handshake
        int n;
        while ((n = in.read(buffer)) > 0) {
            link.delay();
            out.write(buffer, 0, n);
        }
    }

    private void down(InputStream in, OutputStream out) throws IOException {
        byte[] buffer = new byte[BUFFER_BYTES];
        int n;
        while ((n = in.read(buffer, 0, link.portion())) > 0) {
            link.carry(n);
            carried.addAndGet(n);
            copy.write(buffer, 0, n);
            out.write(buffer, 0, n);
        }
    }

    private interface Task {
        void run() throws IOException;
    }

    private static void start(String name, Task task) {
        Thread thread = new Thread(
                () -> {
                    try {
                        task.run();
                    } catch (IOException e) {
                        // one side is gone: so is the other
                    }
                },
                name);
        thread.setDaemon(true);
        thread.start();
    }
}
