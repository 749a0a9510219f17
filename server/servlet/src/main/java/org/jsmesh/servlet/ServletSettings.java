package org.jsmesh.servlet;

import java.util.List;

/**
 * How the servlet answers.
 *
 * @param origins of pages that may read archives with scripts, such as {@code https://example.org}; {@code *} for all
 * @param portionBytes most bytes of an archive that are handed to the container at once; some containers copy what a
 *     slow reader leaves of them
 * @param page address of a page that shows the models, relative to the catalogue: browsers that open the catalogue are
 *     sent there; null when there is none, and browsers get the catalogue as JSON like everybody else
 */
public record ServletSettings(List<String> origins, int portionBytes, String page) {
    private static final int SMALL_PORTION = 1 << 16;

    /**
     * Checks the settings.
     *
     * @param origins see {@link #origins()}
     * @param portionBytes see {@link #portionBytes()}
     * @param page see {@link #page()}
     */
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

    /** {@return settings by which pages from anywhere may read archives} */
    public static ServletSettings defaults() {
        return new ServletSettings(List.of("*"), SMALL_PORTION, null);
    }

    /**
     * Changes whose pages may read archives.
     *
     * @param allowed origins, or {@code *} for all
     * @return settings that differ in that alone
     */
    public ServletSettings withOrigins(List<String> allowed) {
        return new ServletSettings(allowed, portionBytes, page);
    }

    /**
     * Changes how many bytes the container is handed at once.
     *
     * @param bytes at least 1
     * @return settings that differ in that alone
     */
    public ServletSettings withPortionBytes(int bytes) {
        return new ServletSettings(origins, bytes, page);
    }

    /**
     * Changes the page that browsers are sent to.
     *
     * @param address relative to the catalogue, or null for none
     * @return settings that differ in that alone
     */
    public ServletSettings withPage(String address) {
        return new ServletSettings(origins, portionBytes, address);
    }
}
