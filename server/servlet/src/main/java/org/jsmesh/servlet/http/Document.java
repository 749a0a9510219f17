package org.jsmesh.servlet.http;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.EnumMap;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;

/** A file or text to be sent: packed for clients that accept that, with tags for conditional requests. Immutable. */
public final class Document {
    private static final int SMALLEST_COMPRESSED = 1024;

    private final String type;
    private final Map<ContentCoding, byte[]> bodies;
    private final String sha256;

    private Document(String type, byte[] bytes, Map<ContentCoding, byte[]> packed, String sha256) {
        this.type = type;
        bodies = new EnumMap<>(ContentCoding.class);
        bodies.putAll(packed);
        if (bytes != null) bodies.put(ContentCoding.IDENTITY, bytes);
        this.sha256 = sha256;
    }

    /**
     * Packs a text or file itself, where that pays.
     *
     * @param type of its content
     * @param bytes as they are
     * @return the document
     * @throws IOException never
     */
    public static Document of(String type, byte[] bytes) throws IOException {
        byte[] gzip = bytes.length < SMALLEST_COMPRESSED ? bytes : compress(bytes);
        boolean pays = gzip.length <= bytes.length * 9 / 10;
        return of(type, bytes, pays ? Map.of(ContentCoding.GZIP, gzip) : Map.of());
    }

    /**
     * Keeps a text in its packed form alone, and unpacks it for the few clients that take no other.
     *
     * @param type of its content
     * @param bytes as they are
     * @return the document
     * @throws IOException never
     */
    public static Document compact(String type, byte[] bytes) throws IOException {
        Document document = of(type, bytes);
        byte[] gzip = document.bodies.get(ContentCoding.GZIP);
        return gzip == null ? document : new Document(type, null, Map.of(ContentCoding.GZIP, gzip), document.sha256);
    }

    /**
     * What has been packed before.
     *
     * @param type of its content
     * @param bytes as they are
     * @param packed the same bytes, packed
     * @return the document
     */
    public static Document of(String type, byte[] bytes, Map<ContentCoding, byte[]> packed) {
        return new Document(type, bytes, packed, Digests.sha256(bytes));
    }

    /**
     * The text or file as it is.
     *
     * @return a copy of its bytes
     */
    public byte[] bytes() {
        return body(ContentCoding.IDENTITY).clone();
    }

    private byte[] body(ContentCoding coding) {
        byte[] body = bodies.get(coding);
        if (body != null) return body;
        try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(bodies.get(ContentCoding.GZIP)))) {
            return in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static byte[] compress(byte[] bytes) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (GZIPOutputStream gzip = new GZIPOutputStream(out)) {
            gzip.write(bytes);
        }
        return out.toByteArray();
    }

    /**
     * Answers a request with it, or says that the client has it already.
     *
     * @param request a GET or HEAD
     * @param response nothing of which was sent
     * @param cacheControl how long it may be kept
     * @throws IOException when the client is gone
     */
    public void send(HttpServletRequest request, HttpServletResponse response, String cacheControl) throws IOException {
        ContentCoding coding = choose(request.getHeader("Accept-Encoding"));
        boolean isPacked = coding != ContentCoding.IDENTITY;
        String tag = '"' + sha256 + (isPacked ? "-" + coding.token() : "") + '"';
        response.setHeader("Cache-Control", cacheControl);
        response.addHeader("Vary", "Accept-Encoding");
        if (EntityTags.answer(request, response, tag)) return;
        byte[] body = body(coding);
        if (isPacked) response.setHeader("Content-Encoding", coding.token());
        response.setContentType(type);
        response.setContentLengthLong(body.length);
        if (!request.getMethod().equals("HEAD")) ResponseSender.start(request, response, body);
    }

    /** What the client likes best; of equals the tightest. Whoever accepts nothing gets the bytes as they are. */
    private ContentCoding choose(String acceptEncoding) {
        ContentCoding best = ContentCoding.IDENTITY;
        double most = 0;
        for (ContentCoding coding : ContentCoding.values()) {
            if (coding != ContentCoding.IDENTITY && !bodies.containsKey(coding)) continue;
            double weight = coding.weight(acceptEncoding);
            if (weight > most) {
                best = coding;
                most = weight;
            }
        }
        return best;
    }
}
