package org.jsmesh.app;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Hosts that know less than a jSM server: one like {@code python3 -m http.server}, one like an object store. */
final class DumbHost implements AutoCloseable {
    private static final Pattern RANGE = Pattern.compile("bytes=(\\d+)-(\\d*)");

    /** What a request for an archive was answered. */
    record Answer(String method, String target, String range, String ifRange, int status) {}

    private final HttpServer server;
    private final ExecutorService threads = Executors.newCachedThreadPool();
    private final List<Answer> archives = new CopyOnWriteArrayList<>();
    private final Path root;
    private final String signature;

    private DumbHost(Path root, String signature) throws IOException {
        this.root = root;
        this.signature = signature;
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        server.createContext("/", this::handle);
        server.setExecutor(threads);
        server.start();
    }

    /** Sends whole files, with a date and without a tag. */
    static DumbHost withoutRanges(Path root) throws IOException {
        return new DumbHost(root, null);
    }

    /**
     * Knows ranges, but neither If-Range nor any type; its tags are none of ours. Answers only where the query is the
     * signature. Pages of other origins may read answers, but none of their headers, and may send none that needs
     * permission.
     */
    static DumbHost objectStore(Path root, String signature) throws IOException {
        return new DumbHost(root, signature);
    }

    URI uri() {
        return URI.create("http://127.0.0.1:" + server.getAddress().getPort() + "/");
    }

    List<Answer> archives() {
        return List.copyOf(archives);
    }

    private void handle(HttpExchange exchange) throws IOException {
        try (exchange) {
            String path = exchange.getRequestURI().getPath();
            Path file = root.resolve(path.substring(1) + (path.endsWith("/") ? "index.html" : ""));
            String method = exchange.getRequestMethod();
            boolean allowed = signature == null
                    || signature.equals(exchange.getRequestURI().getRawQuery());
            if (!method.equals("GET") || !allowed) exchange.sendResponseHeaders(403, -1);
            else if (!Files.isRegularFile(file)) exchange.sendResponseHeaders(404, -1);
            else send(exchange, Files.readAllBytes(file), path);
            if (path.endsWith(".jsm") && !path.endsWith("/first.jsm")) {
                Headers asked = exchange.getRequestHeaders();
                archives.add(new Answer(
                        method,
                        exchange.getRequestURI().toString(),
                        asked.getFirst("Range"),
                        asked.getFirst("If-Range"),
                        exchange.getResponseCode()));
            }
        } catch (IOException e) {
            // The client has gone away.
        }
    }

    private void send(HttpExchange exchange, byte[] file, String path) throws IOException {
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", type(path));
        String range = exchange.getRequestHeaders().getFirst("Range");
        int from = 0;
        int to = file.length;
        if (signature != null) {
            headers.set("ETag", "\"9b2cf535f27731c974343645a3985328-2\"");
            headers.set("Access-Control-Allow-Origin", "*");
            Matcher wanted = RANGE.matcher(range == null ? "" : range);
            if (wanted.matches()) {
                from = Integer.parseInt(wanted.group(1));
                if (!wanted.group(2).isEmpty()) to = Math.min(to, Integer.parseInt(wanted.group(2)) + 1);
                headers.set("Content-Range", "bytes " + from + "-" + (to - 1) + "/" + file.length);
            }
        } else {
            headers.set("Last-Modified", "Sun, 22 Nov 2026 12:00:00 GMT");
        }
        exchange.sendResponseHeaders(headers.containsKey("Content-Range") ? 206 : 200, to - from);
        try (OutputStream out = exchange.getResponseBody()) {
            out.write(file, from, to - from);
        }
    }

    private String type(String path) {
        if (signature != null) return "binary/octet-stream";
        if (path.endsWith(".js")) return "text/javascript";
        if (path.endsWith(".css")) return "text/css";
        if (path.endsWith(".svg")) return "image/svg+xml";
        return path.endsWith("/") || path.endsWith(".html") ? "text/html" : "application/octet-stream";
    }

    @Override
    public void close() {
        server.stop(0);
        threads.shutdownNow();
    }
}
