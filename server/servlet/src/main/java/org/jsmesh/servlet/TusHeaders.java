package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;

/** Header fields of the tus protocol 1.0.0 ({@code tus.io/protocols/resumable-upload}). */
final class TusHeaders {
    static final String VERSION = "1.0.0";
    static final String EXTENSIONS = "creation,creation-with-upload,expiration,checksum,termination";
    static final String ALGORITHMS = "sha1,sha256";
    static final String PART = "application/offset+octet-stream";
    private static final Map<String, String> DIGESTS = Map.of("sha1", "SHA-1", "sha256", "SHA-256");
    private static final Pattern NUMBER = Pattern.compile("\\d{1,18}");
    private static final int LONGEST_METADATA = 4096;

    private TusHeaders() {}

    /** A digest to be taken, and the value that it must have. */
    record Checksum(MessageDigest digest, byte[] value) {
        static final Checksum NONE = new Checksum(null, null);
    }

    /** The value of a field; -1 when there is none, or no number. */
    static long number(HttpServletRequest request, String field) {
        String text = request.getHeader(field);
        return text != null && NUMBER.matcher(text).matches() ? Long.parseLong(text) : -1;
    }

    /** Whether the body is a part of a file. */
    static boolean isPart(HttpServletRequest request) {
        String type = request.getContentType();
        return type != null && type.replaceFirst(";.*$", "").strip().equalsIgnoreCase(PART);
    }

    /**
     * The keys and values of {@code Upload-Metadata}; empty without the field.
     *
     * @throws IllegalArgumentException when it is malformed
     */
    static Map<String, String> metadata(String field) {
        Map<String, String> metadata = new LinkedHashMap<>();
        if (field == null || field.isBlank()) return metadata;
        if (field.length() > LONGEST_METADATA || !field.matches("[!-~ ]*"))
            throw new IllegalArgumentException("Upload-Metadata is too long or not ASCII");
        for (String pair : field.split(",")) {
            String[] words = pair.strip().split(" +", 2);
            String value = words.length == 1 ? "" : words[1].strip();
            try {
                String text = new String(Base64.getDecoder().decode(value), StandardCharsets.UTF_8);
                if (words[0].isEmpty() || metadata.put(words[0], text) != null) throw malformed("Upload-Metadata");
            } catch (IllegalArgumentException e) {
                throw malformed("Upload-Metadata");
            }
        }
        return metadata;
    }

    /**
     * What {@code Upload-Checksum} says of a part.
     *
     * @throws IllegalArgumentException when it is malformed, or names another algorithm
     */
    static Checksum checksum(HttpServletRequest request) {
        String field = request.getHeader("Upload-Checksum");
        if (field == null) return Checksum.NONE;
        String[] words = field.strip().split(" +");
        String algorithm = DIGESTS.get(words[0]);
        if (algorithm == null || words.length != 2)
            throw new IllegalArgumentException("Upload-Checksum is none of " + ALGORITHMS);
        try {
            MessageDigest digest = MessageDigest.getInstance(algorithm);
            byte[] value = Base64.getDecoder().decode(words[1]);
            if (value.length != digest.getDigestLength()) throw malformed("Upload-Checksum");
            return new Checksum(digest, value);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    private static IllegalArgumentException malformed(String field) {
        return new IllegalArgumentException(field + " is malformed");
    }
}
