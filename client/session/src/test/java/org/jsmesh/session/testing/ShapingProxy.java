package org.jsmesh.session.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;

/**
 * A TCP proxy on 127.0.0.1 that behaves like a poor link: limited rate, delay, connections that break after so many
 * bytes, and a log of the HTTP/1.1 requests that pass. Needs no rights. Bodies of answers must have a Content-Length.
 */
public final class ShapingProxy implements AutoCloseable {
    private final ServerSocket listener;
    private final InetSocketAddress target;
    private final ShapedLink link = new ShapedLink();
    private final List<ProxiedExchange> exchanges = new ArrayList<>();
    private final Queue<Socket> sockets = new ConcurrentLinkedQueue<>();
    private volatile long delayMillis;
    private long cutAfter = Long.MAX_VALUE;
    private long cutHeadAfter = Long.MAX_VALUE;
    private volatile boolean stalling;
    private long corruptAt = -1;
    private volatile String refused;
    private int connections;
    private volatile boolean closed;

    private ShapingProxy(InetSocketAddress target) throws IOException {
        this.target = target;
        listener = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        start("proxy-accept", this::accept);
    }

    /** A proxy in front of a server on this machine. */
    public static ShapingProxy to(int port) throws IOException {
        return new ShapingProxy(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    }

    /** A proxy in front of the server of an address. */
    public static ShapingProxy to(URI server) throws IOException {
        return new ShapingProxy(new InetSocketAddress(server.getHost(), server.getPort()));
    }

    /** The rate towards the client from now on, all connections together. */
    public ShapingProxy bytesPerSecond(double rate) {
        link.setBytesPerSecond(rate);
        return this;
    }

    /** How long each request is held back: the round-trip time. */
    public ShapingProxy delayMillis(long millis) {
        delayMillis = millis;
        return this;
    }

    /** Breaks the connection after so many more bytes of bodies; once. */
    public synchronized ShapingProxy cutAfter(long bodyBytes) {
        cutAfter = bodyBytes;
        return this;
    }

    /** Breaks the connection after so many bytes of the head of the next answer; once. */
    public synchronized ShapingProxy cutHeadAfter(long headBytes) {
        cutHeadAfter = headBytes;
        return this;
    }

    /** Connections that would break fall silent instead, and stay open until the client gives up. */
    public ShapingProxy stalling() {
        stalling = true;
        return this;
    }

    /** Flips the lowest bit of the byte of the file at this offset whenever it passes. */
    public synchronized ShapingProxy corruptByte(long offset) {
        corruptAt = offset;
        return this;
    }

    /** Makes every answer to a request whose target ends so a 500. */
    public ShapingProxy refuse(String targetEnd) {
        refused = targetEnd;
        return this;
    }

    public int port() {
        return listener.getLocalPort();
    }

    /** The same path through this proxy. */
    public URI through(URI address) {
        return URI.create("http://127.0.0.1:" + port() + address.getRawPath()
                + (address.getRawQuery() == null ? "" : "?" + address.getRawQuery()));
    }

    /** The requests so far, in the order in which they came. */
    public synchronized List<ProxiedExchange> exchanges() {
        return List.copyOf(exchanges);
    }

    /** Bytes of all bodies passed on. */
    public synchronized long bodyBytes() {
        return exchanges.stream().mapToLong(ProxiedExchange::bodyBytes).sum();
    }

    @Override
    public void close() throws IOException {
        closed = true;
        listener.close();
        for (Socket s : sockets) closeQuietly(s);
    }

    private void accept() {
        while (!closed) {
            try {
                Socket client = listener.accept();
                Socket server = new Socket();
                sockets.add(client);
                sockets.add(server);
                client.setTcpNoDelay(true);
                client.setSendBufferSize(16384);
                server.setTcpNoDelay(true);
                server.setReceiveBufferSize(65536);
                server.connect(target);
                new Connection(client, server, connections++).start();
            } catch (IOException e) {
                if (!closed && !(e instanceof SocketException)) throw new java.io.UncheckedIOException(e);
            }
        }
    }

    private static void start(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
    }

    private static void closeQuietly(Socket socket) {
        try {
            socket.close();
        } catch (IOException e) {
            // it is gone either way
        }
    }

    private final class Connection {
        private final Socket client;
        private final Socket server;
        private final int number;
        private final Queue<Integer> unanswered = new ArrayDeque<>();

        Connection(Socket client, Socket server, int number) {
            this.client = client;
            this.server = server;
            this.number = number;
        }

        void start() {
            ShapingProxy.start("proxy-up-" + number, () -> run(this::requests));
            ShapingProxy.start("proxy-down-" + number, () -> run(this::answers));
        }

        private interface Direction {
            void copy() throws IOException;
        }

        private void run(Direction direction) {
            try {
                direction.copy();
            } catch (IOException e) {
                // one side broke: so does the other
            } finally {
                closeQuietly(client);
                closeQuietly(server);
            }
        }

        private void requests() throws IOException {
            InputStream in = client.getInputStream();
            OutputStream out = server.getOutputStream();
            HttpHeadReader head = new HttpHeadReader();
            byte[] buffer = new byte[8192];
            long body = 0;
            int n;
            while ((n = in.read(buffer)) > 0) {
                for (int i = 0; i < n; i++) {
                    if (body > 0) body--;
                    else if (head.accept(buffer[i])) {
                        body = head.length();
                        begin(head);
                    }
                }
                long end = System.nanoTime() + delayMillis * 1_000_000;
                long left;
                while ((left = end - System.nanoTime()) > 0) LockSupport.parkNanos(left);
                out.write(buffer, 0, n);
                out.flush();
            }
        }

        private void begin(HttpHeadReader head) {
            synchronized (ShapingProxy.this) {
                unanswered.add(exchanges.size());
                exchanges.add(new ProxiedExchange(
                        number, head.word(0), head.word(1), head.field("range"), head.field("if-range"), 0, 0, 0));
            }
        }

        private void answers() throws IOException {
            InputStream in = server.getInputStream();
            OutputStream out = client.getOutputStream();
            HttpHeadReader head = new HttpHeadReader();
            byte[] buffer = new byte[16384];
            int exchange = -1;
            long body = 0;
            int headBytes = 0;
            int n;
            while ((n = in.read(buffer, 0, link.portion())) > 0) {
                int at = 0;
                while (at < n) {
                    int from = at;
                    if (body == 0) {
                        boolean complete = false;
                        while (at < n && !complete) {
                            if (isHeadCut(headBytes)) {
                                out.write(buffer, from, at - from);
                                breakOff(out);
                                return;
                            }
                            int digit = headBytes++ - "HTTP/1.1 ".length();
                            if (digit >= 0 && digit < 3 && isRefused()) buffer[at] = (byte) "500".charAt(digit);
                            complete = head.accept(buffer[at++]);
                        }
                        if (complete) {
                            headBytes = 0;
                            exchange = answered(head);
                            body = head.length();
                        }
                    } else {
                        int pass = passOn(exchange, (int) Math.min(body, n - at), buffer, at);
                        boolean cut = pass < Math.min(body, n - at);
                        at += pass;
                        body -= pass;
                        if (cut) {
                            link.carry(at - from);
                            out.write(buffer, from, at - from);
                            breakOff(out);
                            return;
                        }
                    }
                    link.carry(at - from);
                    out.write(buffer, from, at - from);
                }
                out.flush();
            }
        }

        private boolean isHeadCut(int headBytes) {
            synchronized (ShapingProxy.this) {
                if (headBytes != cutHeadAfter) return false;
                cutHeadAfter = Long.MAX_VALUE;
                return true;
            }
        }

        /** The end of this connection: at once, or when the client loses patience. */
        private void breakOff(OutputStream out) throws IOException {
            out.flush();
            while (stalling && !closed && !client.isClosed()) LockSupport.parkNanos(5_000_000);
        }

        /** Whether the answer that begins is to be a 500. */
        private boolean isRefused() {
            if (refused == null) return false;
            synchronized (ShapingProxy.this) {
                return exchanges.get(unanswered.element()).target().endsWith(refused);
            }
        }

        private int answered(HttpHeadReader head) {
            int status = Integer.parseInt(head.word(1));
            String range = head.field("content-range");
            long from = range == null || !range.startsWith("bytes ") || range.startsWith("bytes *")
                    ? 0
                    : Long.parseLong(range.substring(6, range.indexOf('-')));
            synchronized (ShapingProxy.this) {
                int i = unanswered.remove();
                ProxiedExchange e = exchanges.get(i);
                exchanges.set(
                        i,
                        new ProxiedExchange(
                                e.connection(), e.method(), e.target(), e.range(), e.ifRange(), status, from, 0));
                return i;
            }
        }

        /** How many of these body bytes may pass before the cut; counts them. */
        private int passOn(int exchange, int bytes, byte[] buffer, int at) {
            synchronized (ShapingProxy.this) {
                int pass = (int) Math.min(bytes, cutAfter);
                cutAfter = pass < bytes ? Long.MAX_VALUE : cutAfter == Long.MAX_VALUE ? cutAfter : cutAfter - pass;
                ProxiedExchange e = exchanges.get(exchange);
                long corrupt = corruptAt - e.fromByte() - e.bodyBytes();
                if (corruptAt >= 0 && corrupt >= 0 && corrupt < pass) buffer[at + (int) corrupt] ^= 1;
                exchanges.set(
                        exchange,
                        new ProxiedExchange(
                                e.connection(),
                                e.method(),
                                e.target(),
                                e.range(),
                                e.ifRange(),
                                e.status(),
                                e.fromByte(),
                                e.bodyBytes() + pass));
                return pass;
            }
        }
    }
}
