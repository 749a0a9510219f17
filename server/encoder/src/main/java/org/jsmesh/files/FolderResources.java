package org.jsmesh.files;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jsmesh.mesh.io.CompanionPaths;
import org.jsmesh.mesh.io.Resource;
import org.jsmesh.mesh.io.ResourceResolver;

/**
 * Finds the companions of a model (material libraries, images, buffers) in a folder and below it. Their paths come out
 * of the model and are not trusted: whatever they say, no file outside of the folder is read. Absolute paths, paths
 * with {@code ..} or the letter of a drive, symbolic links and names that the system does not take find nothing when
 * they lead out.
 *
 * <p>A path that finds nothing is tried whatever the case of its letters, and then by its last part, because many
 * exporters write the paths of their own machine: {@code C:\Users\me\Wood.PNG} finds {@code wood.png} in the folder,
 * see {@link CompanionPaths}. Files of more than 256 MiB are not read. Immutable and thread-safe.
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
        return locate(path).map(Resource::content);
    }

    @Override
    public Optional<Resource> locate(String path) throws IOException {
        Optional<Resource> exact = inside(path.replace('\\', '/'));
        if (exact.isPresent()) return exact;
        Optional<String> other = CompanionPaths.match(path, this::names);
        return other.isPresent() ? inside(other.get()) : Optional.empty();
    }

    private Optional<Resource> inside(String relative) throws IOException {
        Path file = resolve(relative);
        if (file == null || !Files.isRegularFile(file)) return Optional.empty();
        // Behind all links; what is checked is what is read.
        Path real = file.toRealPath();
        if (!isWithin(real) || Files.size(real) > LARGEST) return Optional.empty();
        String path = folder.relativize(file).toString().replace(File.separatorChar, '/');
        return Optional.of(new Resource(path, Files.readAllBytes(real)));
    }

    /** The folders in which {@link #locate} may look for that path, as far as they exist. */
    Set<Path> folders(String path) {
        Set<Path> looked = new LinkedHashSet<>();
        looked.add(folder);
        try {
            CompanionPaths.match(path, relative -> {
                Path inner = resolve(relative);
                if (inner != null) looked.add(inner);
                return names(relative);
            });
        } catch (IOException e) {
            // What cannot be listed is watched by its own folder.
        }
        return looked;
    }

    private List<String> names(String relative) throws IOException {
        Path inner = resolve(relative);
        if (inner == null || !Files.isDirectory(inner) || !isWithin(inner.toRealPath())) return List.of();
        try (Stream<Path> entries = Files.list(inner)) {
            return entries.map(entry -> String.valueOf(entry.getFileName())).toList();
        } catch (IOException | UncheckedIOException e) {
            // A folder whose names may not be read has only what is asked for by its exact name.
            return List.of();
        }
    }

    /** Null for what no path can be, and for what leads out. */
    private Path resolve(String relative) {
        try {
            Path path = folder.resolve(relative).normalize();
            return path.startsWith(folder) ? path : null;
        } catch (InvalidPathException e) {
            return null;
        }
    }

    private boolean isWithin(Path real) throws IOException {
        return real.startsWith(folder.toRealPath());
    }
}
