package org.jsmesh.servlet.http;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Ways to pack what is sent, as {@code Content-Encoding} names them; those that pack tighter first. */
public enum ContentCoding {
    /** Brotli. */
    BROTLI("br"),
    /** gzip. */
    GZIP("gzip"),
    /** The bytes as they are. */
    IDENTITY("identity");

    private static final Pattern WEIGHT = Pattern.compile("q=([01](?:\\.\\d{0,3})?)");

    private final String token;

    ContentCoding(String token) {
        this.token = token;
    }

    /** {@return its name in header fields} */
    public String token() {
        return token;
    }

    /**
     * How much a client likes it.
     *
     * @param acceptEncoding the client's header field, or null
     * @return from 0 (never) to 1
     */
    double weight(String acceptEncoding) {
        double ofAny = this == IDENTITY ? Double.MIN_VALUE : 0;
        if (acceptEncoding == null) return ofAny;
        for (String element : acceptEncoding.split(",")) {
            String[] parts = element.strip().toLowerCase(Locale.ROOT).split("\\s*;\\s*", 2);
            if (parts[0].equals(token)) return weight(parts);
            if (parts[0].equals("*")) ofAny = this == IDENTITY ? Math.min(ofAny, weight(parts)) : weight(parts);
        }
        return ofAny;
    }

    /** A weight that nobody can read is that of a coding that is not wanted. */
    private static double weight(String[] parts) {
        if (parts.length == 1) return 1;
        Matcher weight = WEIGHT.matcher(parts[1]);
        return weight.matches() ? Math.min(1, Double.parseDouble(weight.group(1))) : 0;
    }
}
