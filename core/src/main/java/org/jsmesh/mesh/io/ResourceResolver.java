package org.jsmesh.mesh.io;

import java.io.IOException;
import java.util.Optional;

/** Finds the files that a model file refers to: material libraries and images. */
@FunctionalInterface
public interface ResourceResolver {
    /** Finds nothing. */
    ResourceResolver NONE = path -> Optional.empty();

    /**
     * Finds a file.
     *
     * @param path as the model file gives it: untrusted, perhaps absolute, perhaps with {@code ..} or backslashes
     * @return the file's content, or empty when there is none that may be read
     * @throws IOException when it is there but cannot be read
     */
    Optional<byte[]> find(String path) throws IOException;

    /**
     * Finds a file and tells where it is. A resolver that forgives paths which are not quite right, as with
     * {@link CompanionPaths}, overrides this.
     *
     * @param path as the model file gives it, untrusted
     * @return the file, or empty when there is none that may be read
     * @throws IOException when it is there but cannot be read
     */
    default Optional<Resource> locate(String path) throws IOException {
        return find(path).map(content -> new Resource(path, content));
    }
}
