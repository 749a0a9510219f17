package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * Tells cheaply whether a model file has changed: by its size and time, and by those of the material and picture files
 * beside it when its format refers to such files. Files in sub-folders are not watched.
 *
 * @param bytes size of the file
 * @param modifiedNanos time of its last change
 * @param companions sum over the files that it may refer to, 0 when its format refers to none
 */
record SourceStamp(long bytes, long modifiedNanos, long companions) {
    private static final Set<String> REFERRING = Set.of("obj", "ply", "gltf", "gz");
    private static final Set<String> REFERRED = Set.of("mtl", "bin", "png", "jpg", "jpeg", "bmp", "tga", "gif", "webp");

    static SourceStamp of(Path file) throws IOException {
        BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        long companions = REFERRING.contains(extension(file)) ? companions(file) : 0;
        return new SourceStamp(attributes.size(), nanos(attributes), companions);
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

    private static long companions(Path file) throws IOException {
        long sum = 0;
        try (DirectoryStream<Path> siblings =
                Files.newDirectoryStream(file.resolveSibling(""), p -> REFERRED.contains(extension(p)))) {
            for (Path sibling : siblings) {
                BasicFileAttributes attributes = Files.readAttributes(sibling, BasicFileAttributes.class);
                // A sum does not depend on the order in which the file system lists them.
                sum += Objects.hash(fileName(sibling), attributes.size(), nanos(attributes));
            }
        }
        return sum;
    }

    private static long nanos(BasicFileAttributes attributes) {
        return attributes.lastModifiedTime().to(TimeUnit.NANOSECONDS);
    }
}
