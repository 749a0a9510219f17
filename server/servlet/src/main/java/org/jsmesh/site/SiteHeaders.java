package org.jsmesh.site;

import java.util.Locale;

/** What hosts say of the objects of a site. */
final class SiteHeaders {
    static final String JSON = "application/json";
    static final String ARCHIVE = "model/vnd.jsm";
    static final String HTML = "text/html; charset=utf-8";
    static final String JPEG = "image/jpeg";

    /** Of objects that are named after what is in them. */
    static final String FOR_EVER = "public, max-age=31536000, immutable, no-transform";
    /** Of those that are asked for each time whether they are the same. */
    static final String CHANGING = "no-cache";

    private SiteHeaders() {}

    /** The type of a file of the page. */
    static String type(String path) {
        String name = path.toLowerCase(Locale.ROOT);
        if (name.endsWith(".gz")) return type(name.substring(0, name.length() - ".gz".length()));
        if (name.endsWith(".br")) return type(name.substring(0, name.length() - ".br".length()));
        return switch (name.substring(name.lastIndexOf('.') + 1)) {
            case "html" -> HTML;
            case "js", "mjs" -> "text/javascript; charset=utf-8";
            case "css" -> "text/css; charset=utf-8";
            case "json", "map" -> JSON;
            case "svg" -> "image/svg+xml";
            case "wasm" -> "application/wasm";
            case "png" -> "image/png";
            case "jpg" -> JPEG;
            case "txt" -> "text/plain; charset=utf-8";
            default -> "application/octet-stream";
        };
    }
}
