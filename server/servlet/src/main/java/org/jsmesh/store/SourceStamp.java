package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collection;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.TimeUnit;

/**
 * Tells cheaply whether a model file has changed: by its size, its times and its place on the disk, and by those of the
 * files and folders that decide what its companions are.
 *
 * @param bytes size of the file
 * @param modifiedNanos time of its last change
 * @param identity of the file on its disk, and the time when that last took note of a change, where the system tells
 * @param witnesses sum over the others, 0 when there are none
 * @param isFresh whether the file was changed so lately that another change may not move its time
 */
record SourceStamp(long bytes, long modifiedNanos, long identity, long witnesses, boolean isFresh) {
    private static final long FRESH_MILLIS = 100;

    static SourceStamp of(Path file, Collection<Path> witnesses) throws IOException {
        BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        long age = System.currentTimeMillis() - attributes.lastModifiedTime().toMillis();
        return new SourceStamp(
                attributes.size(),
                nanos(attributes),
                identity(file, attributes),
                sum(witnesses),
                Math.abs(age) < FRESH_MILLIS);
    }

    private static long sum(Collection<Path> witnesses) {
        long sum = 0;
        // A set has no order.
        for (Path witness : witnesses) sum += witness.toString().hashCode() * 31L * witness(witness);
        return sum;
    }

    /** The stamp of the same file with those witnesses as they are now. */
    SourceStamp withWitnesses(Collection<Path> paths) {
        return new SourceStamp(bytes, modifiedNanos, identity, sum(paths), isFresh);
    }

    /** A stamp that no file has. */
    SourceStamp withoutTime() {
        return new SourceStamp(bytes, Long.MIN_VALUE, identity, witnesses, isFresh);
    }

    /** Whether file and witnesses are what they were. */
    boolean isSame(SourceStamp other) {
        return bytes == other.bytes
                && modifiedNanos == other.modifiedNanos
                && identity == other.identity
                && witnesses == other.witnesses;
    }

    private static long witness(Path path) {
        try {
            BasicFileAttributes attributes = Files.readAttributes(path, BasicFileAttributes.class);
            return Objects.hash(attributes.size(), nanos(attributes), identity(path, attributes));
        } catch (IOException e) {
            return 0;
        }
    }

    /** A file that is moved to the place of another has other numbers, even if it has the other's size and time. */
    private static long identity(Path file, BasicFileAttributes attributes) throws IOException {
        if (!file.getFileSystem().supportedFileAttributeViews().contains("unix")) {
            return Objects.hashCode(attributes.fileKey());
        }
        return Objects.hash(Files.getAttribute(file, "unix:ctime"), Files.getAttribute(file, "unix:ino"));
    }

    /** The last part of the path, empty for a root. */
    static String fileName(Path path) {
        Path name = path.getFileName();
        return name == null ? "" : name.toString();
    }

    /** The file name's extension in lower case, empty when it has none. */
    static String extension(Path file) {
        String name = fileName(file);
        int dot = name.lastIndexOf('.');
        return dot < 0 ? "" : name.substring(dot + 1).toLowerCase(Locale.ROOT);
    }

    private static long nanos(BasicFileAttributes attributes) {
        return attributes.lastModifiedTime().to(TimeUnit.NANOSECONDS);
    }
}
