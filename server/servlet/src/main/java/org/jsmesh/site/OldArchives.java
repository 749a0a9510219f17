package org.jsmesh.site;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jsmesh.files.ArchiveParts;

/**
 * Archives that a model had before. They stay for a day after they were replaced, so that a client that is reading one
 * can go on to its end. Their own times must not change, because hosts make entity tags of them.
 */
final class OldArchives {
    static final Duration KEPT = Duration.ofDays(1);

    private record Dated(Path file, Instant written) {}

    private OldArchives() {}

    /**
     * Removes those that were replaced more than a day before.
     *
     * @param folder of a model
     * @param current name of its present archive
     * @param manifestWritten when that was named by the manifest
     */
    static void remove(Path folder, String current, Instant manifestWritten, Instant now) throws IOException {
        List<Dated> archives = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*.jsm")) {
            for (Path file : files) {
                FileTime written = Files.getLastModifiedTime(file);
                archives.add(new Dated(file, written.toInstant()));
            }
        }
        archives.sort(Comparator.comparing(Dated::written));
        for (int i = 0; i < archives.size(); i++) {
            Path file = archives.get(i).file();
            if (file.endsWith(current)) continue;
            // The time when the next archive replaced it, or an earlier one when the manifest went back to that.
            Instant replaced = i + 1 < archives.size() ? archives.get(i + 1).written() : manifestWritten;
            if (Duration.between(replaced, now).compareTo(KEPT) > 0) remove(file);
        }
    }

    /** With what was cut out of it. */
    private static void remove(Path archive) throws IOException {
        String path = archive.toString();
        Path parts = archive.getFileSystem().getPath(path.substring(0, path.length() - ".jsm".length()));
        Files.deleteIfExists(parts.resolve(ArchiveParts.FIRST));
        Files.deleteIfExists(parts.resolve(ArchiveParts.POSTER));
        if (Files.isDirectory(parts)) Files.delete(parts);
        Files.deleteIfExists(archive);
    }
}
