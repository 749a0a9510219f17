package org.jsmesh.load.net;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** Status and fields of one response; of HTTP/1.1 taken byte by byte. */
public final class ResponseHead {
    private static final int LARGEST = 16384;

    private final StringBuilder text = new StringBuilder();
    private final Map<String, String> fields;
    private int status;

    /** One of HTTP/1.1 that is still to come. */
    ResponseHead() {
        fields = new HashMap<>();
    }

    /** @param fields with names in small letters */
    ResponseHead(int status, Map<String, String> fields) {
        this.status = status;
        this.fields = fields;
    }

    /** Takes bytes up to the end of the head; true when that is reached. */
    boolean read(ByteBuffer bytes) {
        while (bytes.hasRemaining()) {
            text.append((char) (bytes.get() & 0xff));
            int n = text.length();
            if (n > LARGEST) throw new IllegalStateException("a head of more than " + LARGEST + " bytes");
            if (n >= 4 && text.charAt(n - 1) == '\n' && text.substring(n - 4).equals("\r\n\r\n")) {
                parse();
                return true;
            }
        }
        return false;
    }

    private void parse() {
        String[] lines = text.toString().split("\r\n");
        if (!lines[0].matches("HTTP/1\\.1 \\d{3}.*")) throw new IllegalStateException("no HTTP/1.1: " + lines[0]);
        status = Integer.parseInt(lines[0].substring(9, 12));
        for (int i = 1; i < lines.length; i++) {
            int colon = lines[i].indexOf(':');
            if (colon < 1) throw new IllegalStateException("no field: " + lines[i]);
            fields.put(
                    lines[i].substring(0, colon).toLowerCase(Locale.ROOT),
                    lines[i].substring(colon + 1).strip());
        }
    }

    public int status() {
        return status;
    }

    /** Value of a field, or the empty text. */
    public String field(String name) {
        return fields.getOrDefault(name.toLowerCase(Locale.ROOT), "");
    }

    /** Length of the body; −1 when it lasts until the connection ends. */
    public long length() {
        if (status == 204 || status == 304) return 0;
        String length = field("Content-Length");
        return length.isEmpty() ? -1 : Long.parseLong(length);
    }

    boolean isLast() {
        return field("Connection").equalsIgnoreCase("close") || length() < 0;
    }
}
