package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.mesh.io.ModelFormat;

/** What kind of file a sender says that it sends. */
final class SentName {
    private static final Pattern FILE_NAME = Pattern.compile("(?i);\\s*filename\\s*=\\s*\"?([^\";]+)");

    /** File extensions of content types. For some types only the content tells the format. */
    private static final Map<String, String> EXTENSIONS = Map.ofEntries(
            Map.entry("application/octet-stream", "bin"),
            Map.entry("model/gltf-binary", "glb"),
            Map.entry("model/gltf+json", "gltf"),
            Map.entry("model/stl", "stl"),
            Map.entry("model/x.stl-binary", "stl"),
            Map.entry("application/sla", "stl"),
            Map.entry("application/vnd.ms-pki.stl", "stl"),
            Map.entry("model/obj", "obj"),
            Map.entry("model/ply", "ply"),
            Map.entry("application/ply", "ply"),
            Map.entry("model/off", "off"),
            Map.entry("model/3mf", "3mf"),
            Map.entry("application/vnd.ms-package.3dmanufacturing-3dmodel+xml", "3mf"),
            Map.entry("application/gzip", "gz"),
            Map.entry("application/zip", "zip"),
            Map.entry("application/x-zip-compressed", "zip"));

    private SentName() {}

    /**
     * The extension by the name that the sender gives the file, or else by the type of the content; null when neither
     * is that of a model.
     */
    static String extension(HttpServletRequest request) {
        String name = queryName(request);
        String disposition = request.getHeader("Content-Disposition");
        Matcher file = FILE_NAME.matcher(disposition == null ? "" : disposition);
        if (name == null && file.find()) name = file.group(1);
        return name != null ? ofName(name) : ofType(request.getContentType());
    }

    /** Null when the name is that of no model. */
    static String ofName(String name) {
        String lower = name.toLowerCase(Locale.ROOT).strip();
        if (lower.endsWith(".zip")) return "zip";
        if (ModelFormat.ofName(lower) == null) return null;
        return lower.endsWith(".gz") ? "gz" : lower.substring(lower.lastIndexOf('.') + 1);
    }

    /** Null when the type is that of no model; any model without a type. */
    static String ofType(String type) {
        if (type == null) return "bin";
        return EXTENSIONS.get(type.replaceFirst(";.*$", "").strip().toLowerCase(Locale.ROOT));
    }

    /** Not by getParameter, which would take the body of a form for parameters. */
    private static String queryName(HttpServletRequest request) {
        String query = request.getQueryString();
        if (query == null) return null;
        for (String pair : query.split("&")) if (pair.startsWith("name=")) return pair.substring("name=".length());
        return null;
    }
}
