package org.jsmesh.objects;

import java.nio.charset.StandardCharsets;

/** What keys may be, so that the same ones work in folders and in buckets. */
public final class ObjectKeys {
    /** Of a key's UTF-8 bytes; buckets take no more. */
    private static final int MOST_BYTES = 1024;

    private ObjectKeys() {}

    /**
     * Checks a key.
     *
     * @param key names with slashes between them
     * @return the key
     * @throws IllegalArgumentException when a name is empty, {@code .} or {@code ..}, or holds a character that some
     *     store does not take
     */
    public static String check(String key) {
        if (isKey(key)) return key;
        if (key.length() > MOST_BYTES / 4 && length(key) > MOST_BYTES)
            throw new IllegalArgumentException("the key is longer than " + MOST_BYTES + " bytes: '" + key + "'");
        throw new IllegalArgumentException("no key of an object: '" + key
                + "' (an empty part, '.', '..', a backslash or a control character). Give it another name");
    }

    /**
     * Tells whether a text can be a key.
     *
     * @param text any
     * @return false where {@link #check} fails
     */
    public static boolean isKey(String text) {
        for (String name : text.split("/", -1)) {
            if (name.isEmpty() || name.equals(".") || name.equals("..")) return false;
        }
        return text.chars().noneMatch(c -> c < ' ' || c == '\\') && length(text) <= MOST_BYTES;
    }

    private static int length(String key) {
        return key.getBytes(StandardCharsets.UTF_8).length;
    }
}
