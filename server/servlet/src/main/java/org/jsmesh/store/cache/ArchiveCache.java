package org.jsmesh.store.cache;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.security.DigestInputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jsmesh.files.AtomicFiles;
import org.jsmesh.files.FolderResources;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.sandbox.EncodingFailure;

/**
 * A folder of archives that were encoded earlier, each named by the hash of its bytes, and of {@link Recipes}, which
 * say what they were encoded from. It may be emptied at any time. Beyond its limit of bytes, those that were not used
 * for longest go. Several servers may share it.
 */
public final class ArchiveCache implements AutoCloseable {
    static final String ENDING = "jsm";

    private static final Logger LOG = System.getLogger(ArchiveCache.class.getName());

    /** Free bytes of the disk, besides the size of a model, without which its encoding does not begin. */
    private static final long LEAST_FREE_BYTES = 1L << 20;

    private static final long USED_SECONDS = 60;

    /**
     * An archive that was encoded earlier.
     *
     * @param file its place
     * @param sha256 of its bytes as they were written
     * @param inputs that it was encoded from
     */
    public record Kept(Path file, String sha256, ModelInputs inputs) {}

    private final Path folder;
    private final Recipes recipes;
    private final CacheLimit limit;
    private final WorkFolder work;

    private ArchiveCache(Path folder, CacheLimit limit, WorkFolder work) {
        this.folder = folder;
        this.limit = limit;
        this.work = work;
        recipes = new Recipes(folder);
    }

    /**
     * Makes the folder when it is missing, and removes what servers left in it that were killed.
     *
     * @param mostBytes of all archives in it
     * @param letGo closes the archive of that hash if it is open and nobody reads it; false when somebody does
     * @throws FileSystemException that names the folder, when no file can be made in it
     */
    public static ArchiveCache open(Path folder, long mostBytes, Predicate<String> letGo) throws FileSystemException {
        try {
            Files.createDirectories(folder);
            CacheLimit limit = new CacheLimit(mostBytes, letGo);
            return new ArchiveCache(folder, limit, WorkFolder.open(folder.resolve(".work")));
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
     * The user's cache folder for jSM as the operating system has it, or a fresh temporary folder when that cannot be
     * written. A fixed name in the shared temporary folder would let other users plant archives.
     */
    public static Path defaultFolder() throws IOException {
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

    private Path place(String sha256) {
        return folder.resolve(sha256 + "." + ArchiveCache.ENDING);
    }

    /**
     * Looks for an archive of what the model is now.
     *
     * @param model the model file, which is hashed
     * @param settings everything but the files that the bytes of the archive depend on
     * @return null when there is none
     */
    public Kept find(Path model, String settings) throws IOException {
        for (Recipes.Recipe recipe : recipes.of(sha256(model), settings)) {
            Path file = place(recipe.sha256());
            if (Files.isRegularFile(file) && recipe.inputs().areFoundBy(companions(model))) {
                return new Kept(file, recipe.sha256(), recipe.inputs());
            }
        }
        return null;
    }

    /** Finds companions as encodings do. */
    public static FolderResources companions(Path model) {
        return new FolderResources(model.toAbsolutePath().normalize().getParent());
    }

    /** Notes that an archive is used, at most once a minute. */
    public void used(Path file) {
        try {
            FileTime before = Files.getLastModifiedTime(file);
            long now = System.currentTimeMillis();
            if (now - before.toMillis() > TimeUnit.SECONDS.toMillis(USED_SECONDS))
                Files.setLastModifiedTime(file, FileTime.fromMillis(now));
        } catch (IOException e) {
            // It goes a little earlier then.
        }
    }

    /** Removes an archive that is not what its name says. */
    public void drop(Kept kept) throws IOException {
        Files.deleteIfExists(kept.file());
    }

    /**
     * A place on the cache's disk to encode to. Whoever gets it moves the file away or removes it.
     *
     * @throws EncodingFailure when the disk is full
     */
    public Path begin(Path model) throws IOException {
        Files.createDirectories(folder);
        long free = Files.getFileStore(folder).getUsableSpace();
        if (free < Files.size(model) + LEAST_FREE_BYTES) throw EncodingFailure.noRoom(null);
        return work.next();
    }

    /**
     * Takes an archive in.
     *
     * @param file that was encoded; moved
     * @param sha256 of its bytes
     * @param inputs that were read
     * @return its place from now on
     */
    public Kept keep(Path file, String sha256, ModelInputs inputs, String settings) throws IOException {
        Path place = place(sha256);
        AtomicFiles.move(file, place);
        // Inputs that changed while they were read are nobody's.
        if (inputs.modelSha256() != null) recipes.add(inputs, settings, sha256);
        return new Kept(place, sha256, inputs);
    }

    /** Removes what is too much. Is slow when there is anything, so call it when nobody waits. */
    public void trim() {
        try {
            if (limit.trim(folder)) recipes.prune(sha256 -> Files.exists(place(sha256)));
        } catch (IOException e) {
            LOG.log(Level.WARNING, "Cannot remove archives from the cache " + folder, e);
        }
    }

    private static String sha256(Path model) throws IOException {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            try (InputStream in = new DigestInputStream(Files.newInputStream(model), digest)) {
                byte[] block = new byte[1 << 16];
                while (in.read(block) >= 0) continue;
            }
            return HexFormat.of().formatHex(digest.digest());
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    public void close() {
        try {
            work.close();
        } catch (IOException e) {
            LOG.log(Level.WARNING, "Cannot remove temporary files in " + folder, e);
        }
    }
}
