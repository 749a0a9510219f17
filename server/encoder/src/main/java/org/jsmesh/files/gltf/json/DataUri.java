package org.jsmesh.files.gltf.json;

import java.net.URLDecoder;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Locale;

/** Addresses that are the data themselves (RFC 2397), and the escapes of all addresses. */
public final class DataUri {
    private static final String SCHEME = "data:";

    private DataUri() {}

    /** Whether an address has the data in it. */
    public static boolean is(String uri) {
        return uri.regionMatches(true, 0, SCHEME, 0, SCHEME.length());
    }

    /** The data, or null when they cannot be decoded. */
    public static byte[] bytes(String uri) {
        int comma = uri.indexOf(',');
        if (comma < 0) return null;
        String data = uri.substring(comma + 1);
        if (data.indexOf('%') >= 0) {
            data = decoded(data, StandardCharsets.ISO_8859_1);
            if (data == null) return null;
        }
        if (!isBase64(uri.substring(0, comma))) return data.getBytes(StandardCharsets.ISO_8859_1);
        try {
            return Base64.getMimeDecoder().decode(data);
        } catch (IllegalArgumentException e) {
            return null;
        }
    }

    private static boolean isBase64(String head) {
        return head.toLowerCase(Locale.ROOT).stripTrailing().endsWith(";base64");
    }

    /** An address without escapes, or null when one of them is none. */
    public static String percentDecoded(String uri) {
        return decoded(uri, StandardCharsets.UTF_8);
    }

    private static String decoded(String text, Charset charset) {
        try {
            return URLDecoder.decode(text.replace("+", "%2B"), charset);
        } catch (IllegalArgumentException e) {
            return null;
        }
    }
}
