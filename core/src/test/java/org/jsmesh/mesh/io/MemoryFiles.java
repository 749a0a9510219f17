package org.jsmesh.mesh.io;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

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
