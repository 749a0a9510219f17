package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * Finds the companions of a model (material libraries, images, buffers) in a folder and below it. Their paths come out
 * of the model and are not trusted: whatever they say, no file outside of the folder is read. Absolute paths, paths
 * with {@code ..} or the letter of a drive, symbolic links and names that the system does not take find nothing when
 * they lead out.
 *
 * <p>A path that finds nothing is tried once more by its last part, because many exporters write the paths of their own
 * machine: {@code C:\Users\me\wood.png} finds {@code wood.png} in the folder. Backslashes count as slashes. Files of
 * more than 256 MiB are not read. Immutable and thread-safe.
 */
public final class FolderResources implements ResourceResolver {
    private static final long LARGEST = 1L << 28;

    private final Path folder;

    /** @param folder need not exist; nothing is found then */
    public FolderResources(Path folder) {
        this.folder = folder.toAbsolutePath().normalize();
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
        // Behind all links; what is checked is what is read.
        Path real = file.toRealPath();
        boolean within = real.startsWith(folder.toRealPath());
        return within && Files.size(real) <= LARGEST ? Optional.of(Files.readAllBytes(real)) : Optional.empty();
    }
}
