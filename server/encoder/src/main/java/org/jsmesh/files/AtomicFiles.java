package org.jsmesh.files;

import java.io.IOException;
import java.nio.ByteBuffer;
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
        Path place = OutputFiles.behindLinks(target);
        Path folder = ModelFiles.folder(place);
        Files.createDirectories(folder);
        Path part = folder.resolve("." + ModelFiles.fileName(place) + "." + UUID.randomUUID() + ".part");
        try {
            try (FileChannel channel =
                    FileChannel.open(part, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE)) {
                ByteBuffer rest = ByteBuffer.wrap(content);
                while (rest.hasRemaining()) channel.write(rest);
                // Otherwise a power cut may leave an empty file under the name.
                channel.force(true);
            }
            try {
                Files.move(part, place, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            } catch (AtomicMoveNotSupportedException e) {
                Files.move(part, place, StandardCopyOption.REPLACE_EXISTING);
            }
        } catch (FileSystemException e) {
            throw about(target, e);
        } finally {
            Files.deleteIfExists(part);
        }
    }

    /** The user knows the target, not the file beside it. */
    private static FileSystemException about(Path target, FileSystemException e) {
        String why = e instanceof AccessDeniedException
                ? "access denied"
                : e.getReason() == null ? "the folder takes no files" : e.getReason();
        FileSystemException told = new FileSystemException(
                target.toString(), null, "cannot be written: " + why + ". Choose another place");
        told.initCause(e);
        return told;
    }
}
