package org.jsmesh.servlet;

import java.util.List;

/**
 * How the web application answers.
 *
 * @param origins of pages that may read archives with scripts, such as {@code https://example.org}; {@code *} for all
 */
public record ServletSettings(List<String> origins) {
    public ServletSettings {
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
        return new ServletSettings(List.of("*"));
    }

    public ServletSettings withOrigins(List<String> allowed) {
        return new ServletSettings(allowed);
    }
}
