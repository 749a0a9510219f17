package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * Finds files in a folder and below it. Paths come from model files and are not trusted: absolute ones, {@code ..} and
 * links that lead out find nothing. A path that does not fit is tried once more by its last part, because many
 * exporters write the paths of their own machine.
 */
final class FolderResources implements ResourceResolver {
    private static final long LARGEST = 1L << 28;

    private final Path folder;

    FolderResources(Path folder) {
        this.folder = folder;
    }

    @Override
    public Optional<byte[]> find(String path) throws IOException {
        String unified = path.replace('\\', '/');
        Optional<byte[]> found = inside(unified);
        return found.isPresent() ? found : inside(unified.substring(unified.lastIndexOf('/') + 1));
    }

    private Optional<byte[]> inside(String relative) throws IOException {
        Path file;
        try {
            file = folder.resolve(relative).normalize();
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
        if (!file.startsWith(folder) || !Files.isRegularFile(file)) return Optional.empty();
        boolean within = file.toRealPath().startsWith(folder.toRealPath());
        return within && Files.size(file) <= LARGEST ? Optional.of(Files.readAllBytes(file)) : Optional.empty();
    }
}
