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
        for (String name : key.split("/", -1)) {
            if (name.isEmpty() || name.equals(".") || name.equals(".."))
                throw new IllegalArgumentException("no key of an object: '" + key + "'");
        }
        if (key.indexOf('\\') >= 0 || key.chars().anyMatch(c -> c < ' '))
            throw new IllegalArgumentException("no key of an object: '" + key + "'");
        if (key.getBytes(StandardCharsets.UTF_8).length > MOST_BYTES)
            throw new IllegalArgumentException("the key is longer than " + MOST_BYTES + " bytes: '" + key + "'");
        return key;
    }
}
