package org.jsmesh.files.gltf.json;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashSet;
import java.util.Set;

/** Shortens names that are longer than an archive holds, and remembers them. */
public final class LongNames {
    static final int MOST_BYTES = 1 << 12;

    private static final int MOST_PER_CHARACTER = 3; // of a char in UTF-8

    private final Set<String> shortened = new LinkedHashSet<>();

    /** A name as it fits. */
    public String fit(String name) {
        return fit(name, 0);
    }

    /** A name as it fits with some bytes behind or before it. */
    public String fit(String name, int reserved) {
        if (fits(name, reserved)) return name;
        byte[] bytes = name.getBytes(StandardCharsets.UTF_8);
        int end = MOST_BYTES - reserved;
        while ((bytes[end] & 0xC0) == 0x80) end--; // not within a character
        String fitting = new String(bytes, 0, end, StandardCharsets.UTF_8);
        shortened.add(fitting);
        return fitting;
    }

    /** Whether a name fits with some bytes behind or before it. */
    public static boolean fits(String name, int reserved) {
        int most = MOST_BYTES - reserved;
        return name.length() <= most / MOST_PER_CHARACTER || name.getBytes(StandardCharsets.UTF_8).length <= most;
    }

    /** The names that were too long, as they are now. */
    public Set<String> shortened() {
        return shortened;
    }
}
