package org.jsmesh.servlet;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a {@code Range} field asks of a representation of known length (RFC 9110, section 14). One range is served. Several ranges, other units
 * and anything malformed are answered with the whole, as the RFC allows: many small ranges of one request would cost the server more than
 * they cost the client.
 *
 * @param kind what to answer
 * @param first first byte to send
 * @param length number of bytes to send
 */
record ByteRange(Kind kind, long first, long length) {
    private static final Pattern SINGLE = Pattern.compile("(?i:bytes)\\s*=\\s*(\\d*)\\s*-\\s*(\\d*)\\s*");
    private static final int LONGEST_NUMBER = 18;

    enum Kind {
        WHOLE,
        PART,
        UNSATISFIABLE
    }

    static ByteRange whole(long total) {
        return new ByteRange(Kind.WHOLE, 0, total);
    }

    /**
     * @param field value of the Range field, or null when there is none
     * @param total bytes of the representation, at least 1
     */
    static ByteRange parse(String field, long total) {
        Matcher single = SINGLE.matcher(field == null ? "" : field);
        if (!single.matches()) return whole(total);
        String from = single.group(1);
        String to = single.group(2);
        if (from.isEmpty()) return to.isEmpty() ? whole(total) : suffix(number(to), total);
        long first = number(from);
        long last = to.isEmpty() ? Long.MAX_VALUE : number(to);
        if (last < first) return whole(total);
        if (first >= total) return unsatisfiable();
        return new ByteRange(Kind.PART, first, Math.min(last, total - 1) - first + 1);
    }

    private static ByteRange suffix(long count, long total) {
        if (count == 0) return unsatisfiable();
        long length = Math.min(count, total);
        return new ByteRange(Kind.PART, total - length, length);
    }

    private static ByteRange unsatisfiable() {
        return new ByteRange(Kind.UNSATISFIABLE, 0, 0);
    }

    private static long number(String digits) {
        String significant = digits.replaceFirst("^0+(?=.)", "");
        return significant.length() > LONGEST_NUMBER ? Long.MAX_VALUE : Long.parseLong(significant);
    }

    /** Value of the Content-Range field. */
    String contentRange(long total) {
        return kind == Kind.UNSATISFIABLE
                ? "bytes */" + total
                : "bytes " + first + "-" + (first + length - 1) + "/" + total;
    }
}
