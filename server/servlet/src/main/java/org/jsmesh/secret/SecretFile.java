package org.jsmesh.secret;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.CharacterCodingException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;

/**
 * A file of secrets, one a line, that may change while the server runs. It is looked at when somebody asks, at most
 * once a second, and read when it has changed. Whoever asks sees the old content or the new one, never a mixture. A
 * file that is gone or wrong changes nothing: what was read last stays good, and the log says so once. Thread-safe.
 *
 * @param <T> what becomes of the lines
 */
public final class SecretFile<T> {
    private static final Logger LOG = System.getLogger(SecretFile.class.getName());
    private static final long LOOK_NANOS = 1_000_000_000L;

    /** A file that was changed so shortly before it was read may change again without another time of change. */
    private static final long YOUNG_MILLIS = 3000;

    private final Path file;
    private final Reader<T> reader;
    private final LongSupplier nanos;
    private final AtomicLong looked;
    private volatile T content;
    private Stamp stamp;
    private boolean wrong;

    /**
     * Makes something of the lines.
     *
     * @param <T> what becomes of them
     */
    public interface Reader<T> {
        /**
         * Reads the lines that are neither empty nor begin with a hash.
         *
         * @param lines without white space at their ends
         * @return what they mean
         * @throws IllegalArgumentException that says what is wrong, without any of the secrets
         */
        T read(List<String> lines);
    }

    private record Stamp(long millis, long bytes, Object key, boolean young) {}

    private SecretFile(Path file, Reader<T> reader, LongSupplier nanos) throws IOException {
        this.file = file;
        this.reader = reader;
        this.nanos = nanos;
        looked = new AtomicLong(nanos.getAsLong());
        stamp = stamp();
        content = read();
    }

    /**
     * Reads a file that must be right the first time.
     *
     * @param <T> what becomes of the lines
     * @param file UTF-8 text
     * @param reader makes something of them
     * @return the file, to be asked as often as needed
     * @throws FileSystemException that says what is wrong with the file
     * @throws IOException when it cannot be read
     */
    public static <T> SecretFile<T> open(Path file, Reader<T> reader) throws IOException {
        return new SecretFile<>(file, reader, System::nanoTime);
    }

    static <T> SecretFile<T> open(Path file, Reader<T> reader, LongSupplier nanos) throws IOException {
        return new SecretFile<>(file, reader, nanos);
    }

    /** {@return what the file says, as it was within the last second} */
    public T get() {
        long now = nanos.getAsLong();
        long before = looked.get();
        if (now - before >= LOOK_NANOS && looked.compareAndSet(before, now)) look();
        return content;
    }

    private synchronized void look() {
        Stamp before = stamp;
        boolean wasWrong = wrong;
        stamp = null;
        try {
            stamp = stamp();
            if (before != null && !before.young() && isSame(before, stamp)) return;
            wrong = true;
            content = read();
            wrong = false;
        } catch (IOException e) {
            wrong = true;
            // Told once for each state of the file.
            if (wasWrong && isSame(before, stamp)) return;
            LOG.log(Level.ERROR, "{0}. What was read of the file before stays good.", words(e));
        }
    }

    private static boolean isSame(Stamp a, Stamp b) {
        if (a == null || b == null) return a == b;
        return a.millis() == b.millis() && a.bytes() == b.bytes() && Objects.equals(a.key(), b.key());
    }

    private static String words(IOException e) {
        return e instanceof NoSuchFileException ? e.getMessage() + " is gone" : String.valueOf(e.getMessage());
    }

    private Stamp stamp() throws IOException {
        BasicFileAttributes now = Files.readAttributes(file, BasicFileAttributes.class);
        long millis = now.lastModifiedTime().toMillis();
        boolean young = System.currentTimeMillis() - millis < YOUNG_MILLIS;
        return new Stamp(millis, now.size(), now.fileKey(), young);
    }

    private T read() throws IOException {
        try {
            return reader.read(Files.readAllLines(file).stream()
                    .map(String::strip)
                    .filter(line -> !line.isEmpty() && !line.startsWith("#"))
                    .toList());
        } catch (IllegalArgumentException e) {
            throw new FileSystemException(file.toString(), null, e.getMessage());
        } catch (CharacterCodingException e) {
            throw new FileSystemException(file.toString(), null, "is no text in UTF-8");
        }
    }
}
