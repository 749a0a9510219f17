package org.jsmesh.webapp;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import org.jsmesh.servlet.http.Document;

/** Files of known types that jars carry under {@code META-INF/resources/jsm}, read and compressed once. Thread-safe. */
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

    private final Map<String, Document> files = new ConcurrentHashMap<>();

    /** The file at that path of a request, or null; a path that ends with a slash means the index in it. */
    Document find(String path) throws IOException {
        if (!PATH.matcher(path).matches()) return null;
        String name = path.substring(1) + (path.endsWith("/") ? "index.html" : "");
        Document known = files.get(name);
        if (known != null) return known;
        String type = TYPES.get(name.substring(name.lastIndexOf('.') + 1));
        if (type == null) return null;
        try (InputStream in = PageFiles.class.getClassLoader().getResourceAsStream(FOLDER + name)) {
            if (in == null) return null;
            Document file = Document.of(type, in.readAllBytes());
            files.put(name, file);
            return file;
        }
    }
}
