package org.jsmesh.store;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Locale;

/**
 * A folder of archives that were encoded earlier, with names that say what they were encoded from. It may be emptied at
 * any time.
 */
final class ArchiveCache {
    private final Path folder;

    ArchiveCache(Path folder) {
        this.folder = folder;
    }

    /**
     * The user's cache folder for jSM as the operating system has it, or a fresh temporary folder when that cannot be
     * written. A fixed name in the shared temporary folder would let other users plant archives.
     */
    static Path defaultFolder() throws IOException {
        Path folder = userCache(System.getProperty("os.name", ""), Path.of(System.getProperty("user.home", ".")))
                .resolve("jsm");
        try {
            Files.createDirectories(folder);
            if (Files.isWritable(folder)) return folder;
        } catch (IOException e) {
            // No home, or one that is read-only, as in containers.
        }
        return Files.createTempDirectory("jsm-cache");
    }

    private static Path userCache(String system, Path home) {
        String os = system.toLowerCase(Locale.ROOT);
        if (os.contains("mac")) return home.resolve("Library/Caches");
        String variable = System.getenv(os.contains("win") ? "LOCALAPPDATA" : "XDG_CACHE_HOME");
        return variable == null || variable.isBlank() ? home.resolve(".cache") : Path.of(variable);
    }

    /**
     * Makes the folder when it is missing.
     *
     * @throws FileSystemException that names the folder, when no file can be made in it
     */
    void prepare() throws FileSystemException {
        try {
            Files.createDirectories(folder);
            Files.delete(Files.createTempFile(folder, "encoding", ".part"));
        } catch (IOException e) {
            FileSystemException told = new FileSystemException(
                    folder.toString(),
                    null,
                    "cannot keep archives, no file can be made in this folder. Choose another folder with --cache or jsm.cache");
            told.initCause(e);
            throw told;
        }
    }

    /**
     * The place for the archive of a model.
     *
     * @param model its content is hashed
     * @param circumstances everything else that the bytes of the archive depend on
     */
    Path place(Path model, String circumstances) throws IOException {
        MessageDigest digest = sha256();
        try (InputStream in = Files.newInputStream(model)) {
            byte[] block = new byte[1 << 16];
            for (int count = in.read(block); count >= 0; count = in.read(block)) digest.update(block, 0, count);
        }
        String content = HexFormat.of().formatHex(digest.digest());
        String rest = HexFormat.of().formatHex(sha256().digest(circumstances.getBytes(StandardCharsets.UTF_8)), 0, 6);
        return folder.resolve(content + "-" + rest + "." + FolderScan.ARCHIVE);
    }

    /** Writes the archive whole or not at all, even if another process writes it at the same time. */
    void write(Path place, byte[] archive) throws IOException {
        Files.createDirectories(folder);
        Path part = Files.createTempFile(folder, "encoding", ".part");
        try {
            try (FileChannel channel = FileChannel.open(part, StandardOpenOption.WRITE)) {
                ByteBuffer rest = ByteBuffer.wrap(archive);
                while (rest.hasRemaining()) channel.write(rest);
                channel.force(true);
            }
            Files.move(part, place, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(part);
        }
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }
}
