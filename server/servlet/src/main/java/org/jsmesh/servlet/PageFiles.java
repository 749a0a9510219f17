package org.jsmesh.servlet;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import java.util.zip.GZIPOutputStream;

/** Files of known types that jars carry under {@code META-INF/resources}, read and compressed once. Thread-safe. */
final class PageFiles {
    private static final String FOLDER = "META-INF/resources/";
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
    private static final int SMALLEST_COMPRESSED = 1024;

    private final Map<String, PageFile> files = new ConcurrentHashMap<>();

    /** The file at that path of a request, or null; a path that ends with a slash means the index in it. */
    PageFile find(String path) throws IOException {
        if (!PATH.matcher(path).matches()) return null;
        String name = path.substring(1) + (path.endsWith("/") ? "index.html" : "");
        PageFile known = files.get(name);
        if (known != null) return known;
        String type = TYPES.get(name.substring(name.lastIndexOf('.') + 1));
        if (type == null) return null;
        try (InputStream in = PageFiles.class.getClassLoader().getResourceAsStream(FOLDER + name)) {
            if (in == null) return null;
            PageFile file = PageFile.of(type, in.readAllBytes());
            files.put(name, file);
            return file;
        }
    }

    /** A file as it is sent; {@code gzip} is null when compression does not pay. */
    record PageFile(String type, byte[] bytes, byte[] gzip, String sha256) {
        static PageFile of(String type, byte[] bytes) throws IOException {
            byte[] gzip = bytes.length < SMALLEST_COMPRESSED ? null : compress(bytes);
            if (gzip != null && gzip.length > bytes.length * 9 / 10) gzip = null;
            return new PageFile(type, bytes, gzip, Digests.sha256(bytes));
        }

        private static byte[] compress(byte[] bytes) throws IOException {
            ByteArrayOutputStream out = new ByteArrayOutputStream();
            try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
                gzip.write(bytes);
            }
            return out.toByteArray();
        }
    }
}
