package org.jsmesh.files;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import org.jsmesh.mesh.io.ResourceSink;

/**
 * Writes files into a folder and below it. The model file and its material library may replace older ones. Any other
 * name comes from a model or an archive, so an existing file with other content is left alone.
 */
final class FolderSink implements ResourceSink {
    private final Path folder;
    private final String modelFile;

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
        if (!isOwn(name)) return new Careful(file);
        OutputFiles.requireReplaceable(file);
        return Files.newOutputStream(file);
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

    private static final class Careful extends ByteArrayOutputStream {
        private final Path file;

        Careful(Path file) {
            this.file = file;
        }

        @Override
        public void close() throws IOException {
            if (!Files.exists(file)) {
                Files.write(file, toByteArray());
            } else if (!Files.isRegularFile(file) || !Arrays.equals(Files.readAllBytes(file), toByteArray())) {
                throw new FileAlreadyExistsException(
                        file.toString(), null, "it has other content; write into an empty folder");
            }
        }
    }
}
