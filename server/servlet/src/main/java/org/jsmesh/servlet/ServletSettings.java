package org.jsmesh.servlet;

import java.util.List;

/**
 * How the web application answers.
 *
 * @param origins of pages that may read archives with scripts, such as {@code https://example.org}; {@code *} for all
 * @param portionBytes most bytes of an archive that are handed to the container at once; some copy what a slow reader
 *     leaves of them
 */
public record ServletSettings(List<String> origins, int portionBytes) {
    private static final int SMALL_PORTION = 1 << 16;

    public ServletSettings {
        if (portionBytes < 1) throw new IllegalArgumentException("portionBytes: " + portionBytes);
        origins = List.copyOf(origins);
        for (String origin : origins) {
            if (!origin.matches("\\*|https?://[A-Za-z0-9.\\-\\[\\]:]+")) {
                throw new IllegalArgumentException(
                        "'" + origin + "' is no origin such as https://example.org, and not *");
            }
        }
    }

    /** Archives are public: pages from anywhere may show them. */
    public static ServletSettings defaults() {
        return new ServletSettings(List.of("*"), SMALL_PORTION);
    }

    public ServletSettings withOrigins(List<String> allowed) {
        return new ServletSettings(allowed, portionBytes);
    }

    public ServletSettings withPortionBytes(int bytes) {
        return new ServletSettings(origins, bytes);
    }
}
