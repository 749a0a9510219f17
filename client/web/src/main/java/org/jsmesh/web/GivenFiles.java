package org.jsmesh.web;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.mesh.io.CompanionPaths;
import org.jsmesh.mesh.io.Resource;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * Files that are given with a model: found by their path from the model's folder, then as {@link CompanionPaths} says,
 * then by the last part of the path anywhere.
 */
final class GivenFiles {
    private final Map<String, byte[]> contents = new LinkedHashMap<>();
    private final Map<String, Collection<String>> namesOf = new HashMap<>();
    private final Map<String, String> byLastPart = new HashMap<>();

    void put(String path, byte[] content) {
        if (contents.put(path, content) != null) return;
        byLastPart.putIfAbsent(last(path).toLowerCase(Locale.ROOT), path);
        for (String part = path; !part.isEmpty(); part = parent(part)) {
            Collection<String> names = namesOf.computeIfAbsent(parent(part), folder -> new ArrayList<>());
            if (!names.contains(last(part))) names.add(last(part));
        }
    }

    byte[] get(String path) {
        byte[] content = contents.get(path);
        if (content == null) throw new WrongCallException("no file " + path + " was given");
        return content;
    }

    /** Finds what a model refers to. */
    ResourceResolver around(String model) {
        String folder = parent(model).isEmpty() ? "" : parent(model) + "/";
        return new ResourceResolver() {
            @Override
            public Optional<byte[]> find(String path) throws IOException {
                return locate(path).map(Resource::content);
            }

            @Override
            public Optional<Resource> locate(String path) throws IOException {
                String found = GivenFiles.this.locate(folder, path);
                if (found == null) return Optional.empty();
                String name = found.startsWith(folder) ? found.substring(folder.length()) : found;
                return Optional.of(new Resource(name, contents.get(found)));
            }
        };
    }

    private String locate(String folder, String path) throws IOException {
        Optional<String> near =
                CompanionPaths.match(path, part -> namesOf.getOrDefault(withoutSlash(folder + part), List.of()));
        if (near.isPresent() && contents.containsKey(folder + near.get())) return folder + near.get();
        return byLastPart.get(last(path.replace('\\', '/')).toLowerCase(Locale.ROOT));
    }

    private static String withoutSlash(String path) {
        return path.endsWith("/") ? path.substring(0, path.length() - 1) : path;
    }

    private static String last(String path) {
        return path.substring(path.lastIndexOf('/') + 1);
    }

    private static String parent(String path) {
        return path.substring(0, Math.max(0, path.lastIndexOf('/')));
    }
}
