package org.jsmesh.session;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The header fields of range requests (RFC 9110, section 14). */
final class Ranges {
    private static final Pattern CONTENT_RANGE = Pattern.compile("bytes (\\d{1,18})-(\\d{1,18})/(\\d{1,18}|\\*)");

    private Ranges() {}

    /** @param endByte byte after the last one, or −1 for all that follow */
    static String header(long fromByte, long endByte) {
        return "bytes=" + fromByte + "-" + (endByte < 0 ? "" : endByte - 1);
    }

    /**
     * The value of a Content-Range header.
     *
     * @param toByte byte after the last one
     * @param archiveBytes −1 when not said
     */
    record ContentRange(long fromByte, long toByte, long archiveBytes) {}

    /** Returns null when the value is not a range of bytes. */
    static ContentRange parse(String value) {
        Matcher m = CONTENT_RANGE.matcher(value.trim());
        if (!m.matches()) return null;
        long from = Long.parseLong(m.group(1));
        long last = Long.parseLong(m.group(2));
        long total = m.group(3).equals("*") ? -1 : Long.parseLong(m.group(3));
        return last < from || total >= 0 && last >= total ? null : new ContentRange(from, last + 1, total);
    }

    /** The tag if it is a strong one, which alone may join ranges; else null. */
    static String strongTag(String entityTag) {
        return entityTag != null && entityTag.length() >= 2 && entityTag.startsWith("\"") && entityTag.endsWith("\"")
                ? entityTag
                : null;
    }
}
