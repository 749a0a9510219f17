package org.jsmesh.files;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.mesh.io.ResourceSink;

/**
 * Writes files into a folder and below it: beside their places until {@link #commit}, so that nothing is lost when
 * writing fails or ends in its middle. The model file and its material library may replace older ones. Any other name
 * comes from a model or an archive, so an existing file with other content is left alone.
 */
final class FolderSink implements ResourceSink, AutoCloseable {
    private final Path folder;
    private final String modelFile;

    /** Where each file is until it has its place; the model file, which refers to the others, comes last. */
    private final Map<Path, Path> parts = new LinkedHashMap<>();

    FolderSink(Path folder, String modelFile) {
        this.folder = folder;
        this.modelFile = modelFile;
    }

    @Override
    public OutputStream create(String name) throws IOException {
        Path file = place(name);
        if (!file.startsWith(folder) || file.equals(folder)) throw new IOException(name + " is not within " + folder);
        Path parent = file.getParent();
        if (parent != null) Files.createDirectories(parent);
        boolean within = parent != null && parent.toRealPath().startsWith(folder.toRealPath());
        if (!within) throw new IOException(name + " is not within " + folder + ": a link leads out of it");
        return isOwn(name) ? begin(OutputFiles.behindLinks(file)) : new Careful(file);
    }

    private OutputStream begin(Path file) throws IOException {
        Path part = AtomicFiles.beside(file);
        try {
            OutputStream out = Files.newOutputStream(part, StandardOpenOption.CREATE_NEW);
            parts.put(file, part);
            return out;
        } catch (FileSystemException e) {
            throw AtomicFiles.about(file, e);
        }
    }

    /** Everything is whole: gives each file its place. */
    void commit() throws IOException {
        List<Path> files = new ArrayList<>(parts.keySet());
        files.sort(Comparator.comparing(file -> file.getFileName().toString().equals(modelFile)));
        for (Path file : files) AtomicFiles.publish(parts.get(file), file);
        parts.clear();
    }

    /** Removes what has not got its place. */
    @Override
    public void close() throws IOException {
        for (Path part : parts.values()) Files.deleteIfExists(part);
    }

    private Path place(String name) throws FileSystemException {
        try {
            return folder.resolve(name).normalize();
        } catch (InvalidPathException e) {
            throw PathNames.notWritten(name);
        }
    }

    private boolean isOwn(String name) {
        int dot = modelFile.lastIndexOf('.');
        return name.equals(modelFile) || name.equals((dot > 0 ? modelFile.substring(0, dot) : modelFile) + ".mtl");
    }

    private final class Careful extends ByteArrayOutputStream {
        private final Path file;

        Careful(Path file) {
            this.file = file;
        }

        @Override
        public void close() throws IOException {
            Path there = parts.getOrDefault(file, file);
            if (!Files.exists(there)) {
                try (OutputStream out = begin(file)) {
                    writeTo(out);
                }
            } else if (!Files.isRegularFile(there) || !Arrays.equals(Files.readAllBytes(there), toByteArray())) {
                throw new FileAlreadyExistsException(
                        file.toString(), null, "it has other content; write into an empty folder");
            }
        }
    }
}
