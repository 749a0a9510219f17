package org.jsmesh.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Files of pages that the site had before. They stay for a day after they were replaced, so that a visitor who has such
 * a page open can go on with it.
 */
final class OldPages {
    private static final String FILES = "viewer";

    private OldPages() {}

    /**
     * Removes those that were replaced more than a day before.
     *
     * @param site its folder
     * @param current paths of the files of the page that is there now
     * @param index path of the one that names the others
     */
    static void remove(Path site, Set<String> current, String index, Instant now) throws IOException {
        Instant replaced = Files.getLastModifiedTime(site.resolve(index)).toInstant();
        Path folder = site.resolve(FILES);
        if (!Files.isDirectory(folder) || Duration.between(replaced, now).compareTo(OldArchives.KEPT) <= 0) return;
        List<Path> files;
        try (Stream<Path> walk = Files.walk(folder)) {
            files = walk.filter(Files::isRegularFile).toList();
        }
        for (Path file : files) {
            if (!current.contains(site.relativize(file).toString().replace('\\', '/'))) Files.deleteIfExists(file);
        }
    }
}
