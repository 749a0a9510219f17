package org.jsmesh.servlet.http;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.zip.GZIPOutputStream;

/**
 * A file or text to be sent: compressed for clients that accept that, with a tag for conditional requests.
 *
 * @param gzip the same bytes compressed, or null when that does not pay
 */
public record Document(String type, byte[] bytes, byte[] gzip, String sha256) {
    private static final int SMALLEST_COMPRESSED = 1024;

    public static Document of(String type, byte[] bytes) throws IOException {
        byte[] gzip = bytes.length < SMALLEST_COMPRESSED ? null : compress(bytes);
        if (gzip != null && gzip.length > bytes.length * 9 / 10) gzip = null;
        return new Document(type, bytes, gzip, Digests.sha256(bytes));
    }

    private static byte[] compress(byte[] bytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
            gzip.write(bytes);
        }
        return out.toByteArray();
    }

    public void send(HttpServletRequest request, HttpServletResponse response, String cacheControl) throws IOException {
        boolean compressed = gzip != null && acceptsGzip(request.getHeader("Accept-Encoding"));
        String tag = '"' + sha256 + (compressed ? "-gzip" : "") + '"';
        response.setHeader("ETag", tag);
        response.setHeader("Cache-Control", cacheControl);
        response.addHeader("Vary", "Accept-Encoding");
        if (EntityTags.anyMatches(request.getHeader("If-None-Match"), tag)) {
            response.setStatus(HttpServletResponse.SC_NOT_MODIFIED);
            return;
        }
        byte[] body = compressed ? gzip : bytes;
        if (compressed) response.setHeader("Content-Encoding", "gzip");
        response.setContentType(type);
        response.setContentLengthLong(body.length);
        if (!request.getMethod().equals("HEAD")) ResponseSender.start(request, response, body);
    }

    private static boolean acceptsGzip(String field) {
        if (field == null) return false;
        for (String coding : field.split(",")) {
            String plain = coding.replace(" ", "");
            if (plain.equals("gzip") || plain.startsWith("gzip;q=") && !plain.matches("gzip;q=0(\\.0*)?")) return true;
        }
        return false;
    }
}
