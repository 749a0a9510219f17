package org.jsmesh.webapp;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.EnumMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import org.jsmesh.servlet.http.ContentCoding;
import org.jsmesh.servlet.http.Document;

/**
 * Files of known types that jars carry under {@code META-INF/resources/jsm}, each read once, with what was packed of it
 * when the page was built. Thread-safe.
 */
final class PageFiles {
    private static final String FOLDER = "META-INF/resources/jsm/";
    private static final Pattern PATH =
            Pattern.compile("/(?:[A-Za-z0-9_-][A-Za-z0-9._-]*/)*(?:[A-Za-z0-9_-][A-Za-z0-9._-]*)?");
    private static final Map<String, String> TYPES = Map.ofEntries(
            Map.entry("html", "text/html; charset=utf-8"),
            Map.entry("js", "text/javascript; charset=utf-8"),
            Map.entry("mjs", "text/javascript; charset=utf-8"),
            Map.entry("css", "text/css; charset=utf-8"),
            Map.entry("txt", "text/plain; charset=utf-8"),
            Map.entry("json", "application/json"),
            Map.entry("map", "application/json"),
            Map.entry("wasm", "application/wasm"),
            Map.entry("svg", "image/svg+xml"),
            Map.entry("png", "image/png"),
            Map.entry("jpg", "image/jpeg"),
            Map.entry("webp", "image/webp"),
            Map.entry("ico", "image/x-icon"),
            Map.entry("woff2", "font/woff2"));

    private static final Map<ContentCoding, String> SUFFIXES =
            Map.of(ContentCoding.BROTLI, ".br", ContentCoding.GZIP, ".gz");
    private static final Pattern HASHED = Pattern.compile("/viewer/[^/]+-[A-Z2-7]{8}\\.[a-z0-9]+");

    private final Map<String, Document> files = new ConcurrentHashMap<>();

    /** The text of the first page, which must be there. */
    static String firstPage() {
        try {
            byte[] page = read("index.html");
            if (page == null) throw new IllegalStateException("the viewer's files are missing: install jSM again");
            return new String(page, StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The file at that path of a request, or null; a path that ends with a slash means the index in it. */
    Document find(String path) throws IOException {
        if (!PATH.matcher(path).matches()) return null;
        String name = path.substring(1) + (path.endsWith("/") ? "index.html" : "");
        Document known = files.get(name);
        if (known != null) return known;
        String type = TYPES.get(name.substring(name.lastIndexOf('.') + 1));
        if (type == null) return null;
        byte[] bytes = read(name);
        if (bytes == null) return null;
        Map<ContentCoding, byte[]> packed = packed(name);
        Document file = packed.isEmpty() ? Document.of(type, bytes) : Document.of(type, bytes, packed);
        files.put(name, file);
        return file;
    }

    private static Map<ContentCoding, byte[]> packed(String name) throws IOException {
        Map<ContentCoding, byte[]> packed = new EnumMap<>(ContentCoding.class);
        for (Map.Entry<ContentCoding, String> suffix : SUFFIXES.entrySet()) {
            byte[] bytes = read(name + suffix.getValue());
            if (bytes != null) packed.put(suffix.getKey(), bytes);
        }
        return packed;
    }

    private static byte[] read(String name) throws IOException {
        try (InputStream in = PageFiles.class.getClassLoader().getResourceAsStream(FOLDER + name)) {
            return in == null ? null : in.readAllBytes();
        }
    }

    /** Whether the path names a file after its content, so that another content would have another path. */
    static boolean isForEver(String path) {
        return HASHED.matcher(path).matches();
    }
}
