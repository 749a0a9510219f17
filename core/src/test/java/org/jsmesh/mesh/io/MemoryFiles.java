package org.jsmesh.mesh.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** A folder in memory, to write models into and read them from. */
final class MemoryFiles implements ResourceSink, ResourceResolver {
    private final Map<String, byte[]> files = new TreeMap<>();

    @Override
    public OutputStream create(String name) {
        if (files.containsKey(name)) throw new IllegalStateException(name + " is created twice");
        files.put(name, new byte[0]);
        return new ByteArrayOutputStream() {
            @Override
            public void close() {
                files.put(name, toByteArray());
            }
        };
    }

    @Override
    public Optional<byte[]> find(String path) {
        return Optional.ofNullable(files.get(path));
    }

    @Override
    public Optional<Resource> locate(String path) throws IOException {
        return CompanionPaths.match(path, this::names)
                .filter(files::containsKey)
                .map(found -> new Resource(found, files.get(found)));
    }

    private Set<String> names(String folder) {
        Set<String> names = new TreeSet<>();
        String start = folder.isEmpty() ? "" : folder + '/';
        for (String file : files.keySet())
            if (file.startsWith(start)) names.add(file.substring(start.length()).split("/")[0]);
        return names;
    }

    MemoryFiles with(String name, String content) {
        files.put(name, content.getBytes(StandardCharsets.UTF_8));
        return this;
    }

    MemoryFiles with(String name, byte[] content) {
        files.put(name, content);
        return this;
    }

    Map<String, byte[]> files() {
        return files;
    }

    String text(String name) {
        return new String(files.get(name), StandardCharsets.UTF_8);
    }

    ModelFile read(String name) throws IOException {
        return ModelReader.read(name, files.get(name), this);
    }
}
