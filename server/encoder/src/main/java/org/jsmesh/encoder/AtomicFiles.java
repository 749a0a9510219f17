package org.jsmesh.encoder;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;

/** Writes files whole or not at all: nobody ever sees half an archive under its name. */
public final class AtomicFiles {
    private AtomicFiles() {}

    /** Writes beside the target, then moves; replaces a file that is there. Makes missing folders. */
    public static void write(Path target, byte[] content) throws IOException {
        Path folder = ModelFiles.folder(target);
        Files.createDirectories(folder);
        Path part = folder.resolve("." + ModelFiles.fileName(target) + "." + UUID.randomUUID() + ".part");
        try {
            Files.write(part, content, StandardOpenOption.CREATE_NEW);
            try {
                Files.move(part, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
            } catch (AtomicMoveNotSupportedException e) {
                Files.move(part, target, StandardCopyOption.REPLACE_EXISTING);
            }
        } finally {
            Files.deleteIfExists(part);
        }
    }
}
