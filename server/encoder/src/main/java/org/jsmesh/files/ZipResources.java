package org.jsmesh.files;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jsmesh.mesh.io.CompanionPaths;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.Resource;
import org.jsmesh.mesh.io.ResourceResolver;
import org.jsmesh.mesh.io.zip.PackedException;
import org.jsmesh.mesh.io.zip.ZipArchive;

/**
 * Finds the companions of a model in the ZIP archive that it came in: by their path from the model's folder, then as
 * {@link CompanionPaths} says, then by the last part of the path anywhere in the archive.
 */
final class ZipResources implements ResourceResolver {
    private final String archive;
    private final ZipArchive zip;
    private final String folder;
    private final Map<String, Set<String>> namesOf = new HashMap<>();
    private final Map<String, String> byLastPart = new HashMap<>();

    /**
     * @param archive its name, for messages
     * @param folder of the model in the archive, empty or with a {@code /} at its end
     */
    ZipResources(String archive, ZipArchive zip, String folder) {
        this.archive = archive;
        this.zip = zip;
        this.folder = folder;
        for (String name : zip.names()) {
            byLastPart.putIfAbsent(last(name).toLowerCase(Locale.ROOT), name);
            for (String part = name; !part.isEmpty(); part = parent(part))
                namesOf.computeIfAbsent(parent(part), f -> new TreeSet<>()).add(last(part));
        }
    }

    @Override
    public Optional<byte[]> find(String path) throws IOException {
        return locate(path).map(Resource::content);
    }

    @Override
    public Optional<Resource> locate(String path) throws IOException {
        String unified = path.replace('\\', '/');
        String exact = normalized(folder + unified);
        if (exact != null && zip.names().contains(exact)) return unpack(exact);
        Optional<String> near =
                CompanionPaths.match(path, f -> namesOf.getOrDefault(withoutSlash(folder + f), Set.of()));
        if (near.isPresent() && zip.names().contains(folder + near.get())) return unpack(folder + near.get());
        String elsewhere = byLastPart.get(last(unified).toLowerCase(Locale.ROOT));
        return elsewhere == null ? Optional.empty() : unpack(elsewhere);
    }

    private static String withoutSlash(String path) {
        return path.endsWith("/") ? path.substring(0, path.length() - 1) : path;
    }

    private static String parent(String path) {
        return path.substring(0, Math.max(0, path.lastIndexOf('/')));
    }

    private Optional<Resource> unpack(String name) throws ModelFormatException {
        try {
            String path = name.startsWith(folder) ? name.substring(folder.length()) : name;
            return Optional.of(new Resource(path, zip.find(name)));
        } catch (PackedException e) {
            throw new ModelFormatException(archive, name, e.reason(), e.remedy());
        }
    }

    /** Without {@code .} and {@code ..}; null when it leads out of the archive. */
    private static String normalized(String path) {
        Deque<String> parts = new ArrayDeque<>();
        for (String part : path.split("/")) {
            if (part.equals("..")) {
                if (parts.pollLast() == null) return null;
            } else if (!part.isEmpty() && !part.equals(".")) {
                parts.addLast(part);
            }
        }
        return String.join("/", parts);
    }

    private static String last(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }
}
