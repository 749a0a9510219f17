package org.jsmesh.servlet.http;

/** Compares entity tags of requests with the strong tag of a representation (RFC 9110, sections 8.8.3 and 13.1). */
public final class EntityTags {
    private EntityTags() {}

    /** For If-None-Match: weak comparison with any tag of a list. */
    public static boolean anyMatches(String field, String tag) {
        if (field == null) return false;
        if (field.strip().equals("*")) return true;
        // Our tags hold no comma, so that splitting cannot make two halves of a foreign tag match.
        for (String candidate : field.split(",")) {
            String plain = candidate.strip();
            if (plain.startsWith("W/")) plain = plain.substring(2);
            if (plain.equals(tag)) return true;
        }
        return false;
    }

    /** For If-Range: strong comparison, and a date never matches because it is no strong validator here. */
    public static boolean isSame(String field, String tag) {
        return field.strip().equals(tag);
    }
}
