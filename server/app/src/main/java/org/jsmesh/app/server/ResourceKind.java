package org.jsmesh.app.server;

/** The kind of a request by its target: one of a few names, whatever clients ask for. */
enum ResourceKind {
    PAGE,
    CATALOGUE,
    MANIFEST,
    ARCHIVE,
    BATCHES,
    PATCHES,
    ENCODE,
    OTHER;

    static final String ROOT = "/m/";

    /** Whether it is a part of an archive. */
    boolean isBytes() {
        return this == ARCHIVE || this == BATCHES || this == PATCHES;
    }

    static ResourceKind of(String method, String path) {
        if (path == null || !path.startsWith(ROOT)) return path != null && path.equals("/m") ? CATALOGUE : PAGE;
        if (!method.matches("GET|HEAD|OPTIONS") || path.startsWith("/m/.uploads")) return ENCODE;
        if (path.length() == ROOT.length()) return CATALOGUE;
        String own = path.substring(ROOT.length());
        if (own.endsWith(".json") && own.indexOf('/') < 0) return CATALOGUE;
        if (path.endsWith(".jsm")) return ARCHIVE;
        if (path.endsWith("/manifest.json")) return MANIFEST;
        if (path.endsWith("/patches")) return PATCHES;
        return path.contains("/batches/") ? BATCHES : OTHER;
    }
}
