package org.jsmesh.store.cache;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;

/**
 * How many bytes of archives a cache folder may hold, and who goes: those that were not used for longest, and none that
 * is being sent, nor the last one.
 */
final class CacheLimit {
    private final long mostBytes;
    private final Predicate<String> letGo;

    private record Row(Path file, String sha256, long bytes, long usedMillis) {}

    /**
     * @param mostBytes of archives
     * @param letGo closes the archive of that hash if it is open and nobody reads it; false when somebody does
     */
    CacheLimit(long mostBytes, Predicate<String> letGo) {
        this.mostBytes = mostBytes;
        this.letGo = letGo;
    }

    /** {@return whether anything was removed} */
    boolean trim(Path folder) throws IOException {
        List<Row> rows = rows(folder);
        long bytes = rows.stream().mapToLong(Row::bytes).sum();
        if (bytes <= mostBytes) return false;
        rows.sort(Comparator.comparingLong(Row::usedMillis).thenComparing(Row::sha256));
        boolean removed = false;
        // The last one was encoded just now, and would be again.
        for (Row row : rows.subList(0, rows.size() - 1)) {
            if (bytes <= mostBytes) break;
            if (!letGo.test(row.sha256())) continue;
            Files.deleteIfExists(row.file());
            bytes -= row.bytes();
            removed = true;
        }
        return removed;
    }

    private static List<Row> rows(Path folder) throws IOException {
        List<Row> rows = new ArrayList<>();
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*." + ArchiveCache.ENDING)) {
            for (Path file : files) {
                try {
                    BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
                    String name = String.valueOf(file.getFileName());
                    rows.add(new Row(
                            file,
                            name.substring(0, name.length() - 1 - ArchiveCache.ENDING.length()),
                            attributes.size(),
                            attributes.lastModifiedTime().toMillis()));
                } catch (NoSuchFileException e) {
                    // Another server has removed it.
                }
            }
        }
        return rows;
    }
}
