package org.jsmesh.session.testing;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** Collects the head of an HTTP/1.1 message, byte by byte. */
final class HttpHeadReader {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private String text;

    /** True when this byte completed the head. */
    boolean accept(byte b) {
        bytes.write(b);
        if (b != '\n' || bytes.size() < 4) return false;
        String all = bytes.toString(StandardCharsets.ISO_8859_1);
        if (!all.endsWith("\r\n\r\n")) return false;
        text = all;
        bytes.reset();
        return true;
    }

    /** The n-th word of the first line. */
    String word(int n) {
        return text.substring(0, text.indexOf('\r')).split(" ")[n];
    }

    /** The value of a header field, or null. */
    String field(String name) {
        for (String line : text.split("\r\n")) {
            int colon = line.indexOf(':');
            if (colon > 0 && line.substring(0, colon).toLowerCase(Locale.ROOT).equals(name))
                return line.substring(colon + 1).trim();
        }
        return null;
    }

    long length() {
        String value = field("content-length");
        return value == null ? 0 : Long.parseLong(value);
    }
}
