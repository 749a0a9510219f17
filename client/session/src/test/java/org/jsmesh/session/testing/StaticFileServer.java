package org.jsmesh.session.testing;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The simplest static host on 127.0.0.1: files from memory, with or without ranges, with or without entity tags. */
public final class StaticFileServer implements AutoCloseable {
    private static final Pattern RANGE = Pattern.compile("bytes=(\\d+)-(\\d*)");

    private record Stored(byte[] bytes, String contentType, String entityTag) {}

    /** A request that came: its path with query, its Range header or null, the status of the answer. */
    public record Request(String target, String range, int status) {}

    private final HttpServer server;
    private final ExecutorService threads = Executors.newCachedThreadPool(task -> {
        Thread thread = new Thread(task, "static-file-server");
        thread.setDaemon(true);
        return thread;
    });
    private final Map<String, Stored> files = new ConcurrentHashMap<>();
    private final List<Request> requests = new CopyOnWriteArrayList<>();
    private final boolean ranges;
    private volatile int failing;
    private volatile String retryAfter;

    private StaticFileServer(boolean ranges) throws IOException {
        this.ranges = ranges;
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.setExecutor(threads);
        server.createContext("/", this::handle);
        server.start();
    }

    /** Answers ranges as RFC 9110 says. */
    public static StaticFileServer withRanges() throws IOException {
        return new StaticFileServer(true);
    }

    /** Always sends whole files. */
    public static StaticFileServer withoutRanges() throws IOException {
        return new StaticFileServer(false);
    }

    /**
     * Stores or replaces a file.
     *
     * @param entityTag with its quotes, or null for none
     */
    public URI put(String path, byte[] bytes, String contentType, String entityTag) {
        files.put(path, new Stored(bytes, contentType, entityTag));
        return URI.create("http://127.0.0.1:" + port() + path);
    }

    /** Takes a file away. */
    public void remove(String path) {
        files.remove(path);
    }

    /** Stores or replaces an archive with a strong entity tag made of its content. */
    public URI put(String path, byte[] bytes) {
        return put(
                path,
                bytes,
                "application/octet-stream",
                "\"" + Integer.toHexString(java.util.Arrays.hashCode(bytes)) + "\"");
    }

    /** Answers a path, and those below it, by other means. */
    public URI handle(String path, HttpHandler handler) {
        server.createContext(path, handler);
        return URI.create("http://127.0.0.1:" + port() + path);
    }

    /** Answers the next requests with 503. */
    public void failNext(int count) {
        failNext(count, null);
    }

    /** Answers the next requests with 503 and this Retry-After, or none. */
    public void failNext(int count, String when) {
        retryAfter = when;
        failing = count;
    }

    public int port() {
        return server.getAddress().getPort();
    }

    /** The requests so far. */
    public List<Request> requests() {
        return List.copyOf(requests);
    }

    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }

    private void handle(HttpExchange exchange) throws IOException {
        try (exchange) {
            Stored file = files.get(exchange.getRequestURI().getPath());
            String range = exchange.getRequestHeaders().getFirst("Range");
            if (failing > 0) {
                failing--;
                if (retryAfter != null) exchange.getResponseHeaders().set("Retry-After", retryAfter);
                answer(exchange, range, 503, null, 0, 0);
            } else if (file == null) {
                answer(exchange, range, 404, null, 0, 0);
            } else {
                send(exchange, range, file);
            }
        }
    }

    private void send(HttpExchange exchange, String range, Stored file) throws IOException {
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", file.contentType());
        if (file.entityTag() != null) headers.set("ETag", file.entityTag());
        String ifRange = exchange.getRequestHeaders().getFirst("If-Range");
        Matcher m = range == null || !ranges ? null : RANGE.matcher(range);
        if (m == null || !m.matches() || ifRange != null && !ifRange.equals(file.entityTag())) {
            answer(exchange, range, 200, file.bytes(), 0, file.bytes().length);
            return;
        }
        long from = Long.parseLong(m.group(1));
        long to = m.group(2).isEmpty()
                ? file.bytes().length
                : Math.min(Long.parseLong(m.group(2)) + 1, file.bytes().length);
        if (from >= to) {
            headers.set("Content-Range", "bytes */" + file.bytes().length);
            answer(exchange, range, 416, null, 0, 0);
            return;
        }
        headers.set("Content-Range", "bytes " + from + "-" + (to - 1) + "/" + file.bytes().length);
        answer(exchange, range, 206, file.bytes(), (int) from, (int) to);
    }

    private void answer(HttpExchange exchange, String range, int status, byte[] bytes, int from, int to)
            throws IOException {
        requests.add(new Request(exchange.getRequestURI().toString(), range, status));
        exchange.sendResponseHeaders(status, bytes == null ? -1 : to - from);
        if (bytes == null) return;
        try (OutputStream out = exchange.getResponseBody()) {
            out.write(bytes, from, to - from);
        }
    }
}
