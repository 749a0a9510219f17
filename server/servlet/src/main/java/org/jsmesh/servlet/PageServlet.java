package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;
import java.util.zip.GZIPOutputStream;

/**
 * The page and its scripts: files that jars carry under {@code META-INF/resources}. A servlet of our own, because every container would send
 * them with other headers, and some with the wrong type for WebAssembly. Folders are not listed.
 */
public final class PageServlet extends HttpServlet {
    private static final long serialVersionUID = 1L;
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

    private final transient ConcurrentHashMap<String, PageFile> files = new ConcurrentHashMap<>();

    @Override
    protected void doGet(HttpServletRequest request, HttpServletResponse response) throws IOException {
        PageFile file = find(request.getServletPath());
        if (file == null) {
            int status = HttpServletResponse.SC_NOT_FOUND;
            Answer.error(request, response, status, "there is no such page", "start at the first page");
            return;
        }
        boolean compressed = file.gzip() != null && acceptsGzip(request.getHeader("Accept-Encoding"));
        String tag = '"' + file.sha256() + (compressed ? "-gzip" : "") + '"';
        response.setHeader("ETag", tag);
        response.setHeader("Cache-Control", "no-cache");
        response.setHeader("Vary", "Accept-Encoding");
        if (EntityTags.anyMatches(request.getHeader("If-None-Match"), tag)) {
            response.setStatus(HttpServletResponse.SC_NOT_MODIFIED);
            return;
        }
        byte[] body = compressed ? file.gzip() : file.bytes();
        if (compressed) response.setHeader("Content-Encoding", "gzip");
        response.setContentType(file.type());
        response.setContentLengthLong(body.length);
        if (!request.getMethod().equals("HEAD")) response.getOutputStream().write(body);
    }

    @Override
    protected void doHead(HttpServletRequest request, HttpServletResponse response) throws IOException {
        doGet(request, response);
    }

    private PageFile find(String path) throws IOException {
        if (!PATH.matcher(path).matches()) return null;
        String name = path.substring(1) + (path.endsWith("/") ? "index.html" : "");
        PageFile known = files.get(name);
        if (known != null) return known;
        String type = TYPES.get(name.substring(name.lastIndexOf('.') + 1));
        if (type == null) return null;
        try (InputStream in = PageServlet.class.getClassLoader().getResourceAsStream(FOLDER + name)) {
            if (in == null) return null;
            PageFile file = PageFile.of(type, in.readAllBytes());
            files.put(name, file);
            return file;
        }
    }

    private static boolean acceptsGzip(String field) {
        if (field == null) return false;
        for (String coding : field.split(",")) {
            String plain = coding.replace(" ", "");
            if (plain.equals("gzip") || plain.startsWith("gzip;q=") && !plain.matches("gzip;q=0(\\.0*)?")) return true;
        }
        return false;
    }

    /** A file as it is sent; {@code gzip} is null when compression does not pay. */
    private record PageFile(String type, byte[] bytes, byte[] gzip, String sha256) {
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
