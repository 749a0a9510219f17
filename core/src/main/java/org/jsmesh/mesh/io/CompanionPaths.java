package org.jsmesh.mesh.io;

import java.io.IOException;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Which of the files beside a model a path in it means. Models are made on systems that do not tell letters of both
 * cases apart and are published with the paths of the machine where they were made.
 *
 * <p>In this order: the path as it is; the path whatever the case of its letters; its last part beside the model, as it
 * is; its last part whatever the case. Backslashes count as slashes. Nothing above the model's folder is ever meant.
 */
public final class CompanionPaths {
    private CompanionPaths() {}

    /** The names in the folders around a model. */
    @FunctionalInterface
    public interface Listing {
        /**
         * Lists a folder.
         *
         * @param folder path with {@code /}, relative to the model's own folder, which is the empty text
         * @return names of the files and folders in it, in any order; none when there is no such folder
         * @throws IOException when it cannot be read
         */
        Collection<String> names(String folder) throws IOException;
    }

    /**
     * Finds the file that a path means.
     *
     * @param path as the model file gives it, untrusted
     * @param listing what there is
     * @return its path with {@code /}, relative to the model's folder; it may be that of a folder
     * @throws IOException from the listing
     */
    public static Optional<String> match(String path, Listing listing) throws IOException {
        List<String> parts = parts(path);
        Optional<String> whole = parts == null ? Optional.empty() : walk(parts, listing);
        if (whole.isPresent()) return whole;
        String unified = path.replace('\\', '/');
        List<String> last = parts(unified.substring(unified.lastIndexOf('/') + 1));
        return last == null ? Optional.empty() : walk(last, listing);
    }

    /** Whether a file's path is the whole of what a model file gives, but for the case of letters. */
    static boolean isWhole(String path, String found) {
        List<String> parts = parts(path);
        return parts != null && key(String.join("/", parts)).equals(key(found.replace('\\', '/')));
    }

    /** The folder of a relative path, without {@code .} and {@code ..}; empty for the model's own or none. */
    static String folder(String path) {
        List<String> parts = parts(path);
        return parts == null || parts.isEmpty() ? "" : String.join("/", parts.subList(0, parts.size() - 1));
    }

    /** A relative path without {@code .}, {@code ..} and backslashes; others as they are. */
    static String normal(String path) {
        List<String> parts = parts(path);
        return parts == null ? path : String.join("/", parts);
    }

    /** Null for an absolute path and one that leads out of the folder. */
    private static List<String> parts(String path) {
        String unified = path.replace('\\', '/');
        if (unified.startsWith("/") || unified.matches("(?s)[A-Za-z]:.*")) return null;
        List<String> parts = new ArrayList<>();
        for (String part : unified.split("/")) {
            if (part.isEmpty() || part.equals(".")) continue;
            if (!part.equals("..")) parts.add(part);
            else if (parts.isEmpty()) return null;
            else parts.remove(parts.size() - 1);
        }
        return parts;
    }

    private static Optional<String> walk(List<String> parts, Listing listing) throws IOException {
        if (parts.isEmpty()) return Optional.empty();
        StringBuilder path = new StringBuilder();
        for (String part : parts) {
            String name = choose(part, listing.names(path.toString()));
            if (name == null) return Optional.empty();
            path.append(path.length() == 0 ? "" : "/").append(name);
        }
        return Optional.of(path.toString());
    }

    private static String choose(String part, Collection<String> names) {
        if (names.contains(part)) return part;
        String key = key(part);
        String chosen = null;
        for (String name : names)
            if (key(name).equals(key) && (chosen == null || name.compareTo(chosen) < 0)) chosen = name;
        return chosen;
    }

    /** Equal for names that differ in the case of letters, or in how these are put together from accents. */
    private static String key(String name) {
        return Normalizer.normalize(name, Normalizer.Form.NFC)
                .toUpperCase(Locale.ROOT)
                .toLowerCase(Locale.ROOT);
    }
}
