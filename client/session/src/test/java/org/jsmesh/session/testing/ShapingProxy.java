package org.jsmesh.session.testing;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.jsmesh.session.link.ShapedLink;

/**
 * A TCP proxy on 127.0.0.1 that behaves like a poor link: limited rate, delay, connections that break after so many
 * bytes, and a log of the HTTP/1.1 requests that pass. Needs no rights. Bodies of answers must have a Content-Length.
 */
public final class ShapingProxy implements AutoCloseable {
    private final ServerSocket listener;
    private final InetSocketAddress target;
    private final ShapedLink link = new ShapedLink();
    private final ExchangeLog exchanges = new ExchangeLog();
    private final LinkFaults faults = new LinkFaults();
    private final Queue<Socket> sockets = new ConcurrentLinkedQueue<>();
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
        link.setDelayMillis(millis);
        return this;
    }

    /** Breaks the connection after so many more bytes of bodies; once. */
    public ShapingProxy cutAfter(long bodyBytes) {
        faults.cutAfter(bodyBytes);
        return this;
    }

    /** Breaks the connection after so many bytes of the head of the next answer; once. */
    public ShapingProxy cutHeadAfter(long headBytes) {
        faults.cutHeadAfter(headBytes);
        return this;
    }

    /** Connections that would break fall silent instead, and stay open until the client gives up. */
    public ShapingProxy stalling() {
        faults.stall();
        return this;
    }

    /** Flips the lowest bit of the byte of the file at this offset whenever it passes. */
    public ShapingProxy corruptByte(long offset) {
        faults.corrupt(offset);
        return this;
    }

    /** Makes every answer to a request whose target ends so a 500; null ends that. */
    public ShapingProxy refuse(String targetEnd) {
        faults.refuse(targetEnd);
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
    public List<ProxiedExchange> exchanges() {
        return exchanges.list();
    }

    /** Bytes of all bodies passed on. */
    public long bodyBytes() {
        return exchanges.list().stream().mapToLong(ProxiedExchange::bodyBytes).sum();
    }

    @Override
    public void close() throws IOException {
        closed = true;
        faults.endStalls();
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
                new ProxyConnection(client, server, connections++, link, exchanges, faults).start();
            } catch (IOException e) {
                if (!closed && !(e instanceof SocketException)) throw new java.io.UncheckedIOException(e);
            }
        }
    }

    static void start(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        thread.start();
    }

    static void closeQuietly(Socket socket) {
        try {
            socket.close();
        } catch (IOException e) {
            // it is gone either way
        }
    }
}
