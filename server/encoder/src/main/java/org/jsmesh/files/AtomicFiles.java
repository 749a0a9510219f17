package org.jsmesh.files;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/** Writes files whole or not at all, so that nobody ever sees half an archive under its name. */
public final class AtomicFiles {
    private AtomicFiles() {}

    /**
     * Writes beside the target, then moves. Replaces a regular file. Makes missing folders.
     *
     * @param target the file to make or to replace
     * @param content all of its bytes
     * @throws FileSystemException that names the target, when it cannot be written or is no regular file
     * @throws IOException when the disk fails
     */
    public static void write(Path target, byte[] content) throws IOException {
        write(target, out -> out.write(content));
    }

    /** What a file will hold. */
    @FunctionalInterface
    public interface Content {
        /**
         * Writes all of it.
         *
         * @param out stays open
         * @throws IOException when it cannot be written
         */
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Likewise, for what is not in one array.
     *
     * @param target the file to make or to replace
     * @param content writes all of its bytes
     * @throws FileSystemException that names the target, when it cannot be written or is no regular file
     * @throws IOException when the disk fails, or from the content
     */
    public static void write(Path target, Content content) throws IOException {
        Path place = OutputFiles.behindLinks(target);
        Path folder = ModelFiles.folder(place);
        Files.createDirectories(folder);
        Path part = beside(place);
        try {
            try (OutputStream out =
                    Files.newOutputStream(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
                content.writeTo(out);
            }
            publish(part, place);
        } catch (FileSystemException e) {
            throw about(target, e);
        } finally {
            Files.deleteIfExists(part);
        }
    }

    /** A new name in the folder of a file, hidden, for its content while that is not whole. */
    static Path beside(Path place) {
        String name = "." + ModelFiles.fileName(place) + "." + UUID.randomUUID() + ".part";
        return ModelFiles.folder(place).resolve(name);
    }

    /** Brings the bytes of a file to disk and gives it its name, where the file system can at once. */
    static void publish(Path part, Path place) throws IOException {
        try (FileChannel channel = FileChannel.open(part, StandardOpenOption.WRITE)) {
            // Otherwise a power cut may leave an empty file under the name.
            channel.force(true);
        }
        try {
            move(part, place);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(part, place, StandardCopyOption.REPLACE_EXISTING);
            syncFolder(ModelFiles.folder(place));
        }
    }

    /**
     * Gives a whole file its name, for good: after a power cut the name stands for the old file or for the new one, and
     * for the new one once this call has returned. The bytes must be on disk already ({@link FileChannel#force}).
     *
     * @param from the file, on the same file system
     * @param to its name from now on; a file of that name is replaced
     * @throws IOException when it cannot be moved at once; then nothing has changed
     */
    public static void move(Path from, Path to) throws IOException {
        Files.move(from, to, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        syncFolder(ModelFiles.folder(to));
    }

    /**
     * Brings what was made, renamed and removed in a folder to disk. Until then a power cut may take it back, even if
     * the bytes of the files are safe. Does nothing where the system opens no folders (Windows) or its disk takes no
     * such wish (some network file systems): what they do about names is then their affair.
     *
     * @param folder whose names count
     */
    public static void syncFolder(Path folder) {
        try (FileChannel names = FileChannel.open(folder, StandardOpenOption.READ)) {
            names.force(true);
        } catch (IOException e) {
            // As said above. A disk that fails has told so when the bytes of the file were forced.
        }
    }

    /** The user knows the target, not the file beside it. */
    static FileSystemException about(Path target, FileSystemException e) {
        String why = e instanceof AccessDeniedException
                ? "access denied"
                : e.getReason() == null ? "the folder takes no files" : e.getReason();
        FileSystemException told = new FileSystemException(
                target.toString(), null, "cannot be written: " + why + ". Choose another place");
        told.initCause(e);
        return told;
    }
}
