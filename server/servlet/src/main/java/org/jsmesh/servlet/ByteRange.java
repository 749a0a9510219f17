package org.jsmesh.servlet;

/**
 * What a {@code Range} field asks of a representation of known length (RFC 9110, section 14). One range is served.
 * Several ranges, other units and anything malformed get the whole, as the RFC allows, because many small ranges in one
 * request would cost the server more than the client.
 *
 * @param kind what to answer
 * @param first first byte to send
 * @param length number of bytes to send
 */
record ByteRange(Kind kind, long first, long length) {
    private static final String UNIT = "bytes";
    private static final long LARGEST = Long.MAX_VALUE / 10 - 1;

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
        if (field == null || !field.regionMatches(true, 0, UNIT, 0, UNIT.length())) return whole(total);
        int equals = skipBlank(field, UNIT.length());
        if (equals == field.length() || field.charAt(equals) != '=') return whole(total);
        int from = skipBlank(field, equals + 1);
        int fromEnd = skipDigits(field, from);
        int hyphen = skipBlank(field, fromEnd);
        if (hyphen == field.length() || field.charAt(hyphen) != '-') return whole(total);
        int to = skipBlank(field, hyphen + 1);
        int toEnd = skipDigits(field, to);
        if (skipBlank(field, toEnd) != field.length()) return whole(total);
        if (from == fromEnd) return to == toEnd ? whole(total) : suffix(number(field, to, toEnd), total);
        long first = number(field, from, fromEnd);
        long last = to == toEnd ? Long.MAX_VALUE : number(field, to, toEnd);
        if (last < first) return whole(total);
        if (first >= total) return unsatisfiable();
        return new ByteRange(Kind.PART, first, Math.min(last, total - 1) - first + 1);
    }

    private static int skipBlank(String field, int at) {
        int i = at;
        while (i < field.length() && (field.charAt(i) == ' ' || field.charAt(i) == '\t')) i++;
        return i;
    }

    private static int skipDigits(String field, int at) {
        int i = at;
        while (i < field.length() && field.charAt(i) >= '0' && field.charAt(i) <= '9') i++;
        return i;
    }

    private static ByteRange suffix(long count, long total) {
        if (count == 0) return unsatisfiable();
        long length = Math.min(count, total);
        return new ByteRange(Kind.PART, total - length, length);
    }

    private static ByteRange unsatisfiable() {
        return new ByteRange(Kind.UNSATISFIABLE, 0, 0);
    }

    /** All numbers too large for a file count the same. */
    private static long number(String field, int from, int to) {
        long value = 0;
        for (int i = from; i < to; i++) {
            if (value > LARGEST) return Long.MAX_VALUE;
            value = 10 * value + field.charAt(i) - '0';
        }
        return value;
    }

    /** Value of the Content-Range field. */
    String contentRange(long total) {
        return kind == Kind.UNSATISFIABLE
                ? "bytes */" + total
                : "bytes " + first + "-" + (first + length - 1) + "/" + total;
    }
}
