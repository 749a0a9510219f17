package org.jsmesh.files;

import java.util.List;
import org.jsmesh.archive.BatchIndex;

/**
 * Parts of an archive that have addresses of their own beside it, in a folder that has the archive's name without its
 * extension. They never change, as the archive does not.
 */
public final class ArchiveParts {
    /** Name of the poster. */
    public static final String POSTER = "poster.jpg";

    /** Name of the first bytes of the archive, see {@link BatchIndex#firstBytes}. */
    public static final String FIRST = "first.jsm";

    private static final String EXTENSION = ".jsm";

    private ArchiveParts() {}

    /**
     * The address of a part.
     *
     * @param archiveUrl address of the archive, which ends with {@code .jsm}
     * @param part its name
     * @return its address, relative to whatever that of the archive is relative to
     */
    public static String url(String archiveUrl, String part) {
        if (!archiveUrl.endsWith(EXTENSION)) throw new IllegalArgumentException("no archive: " + archiveUrl);
        return archiveUrl.substring(0, archiveUrl.length() - EXTENSION.length()) + "/" + part;
    }

    static boolean hasPoster(List<ArchiveReport.BatchRow> rows) {
        return rows.stream().anyMatch(row -> row.kind().equals("poster"));
    }

    /** As {@link BatchIndex#firstBytes}. */
    static long firstBytes(List<ArchiveReport.BatchRow> rows) {
        long first = rows.get(0).bytes();
        for (ArchiveReport.BatchRow row : rows) {
            long end = row.offset() + row.bytes();
            if (end <= BatchIndex.FIRST_FILE_BYTES) first = Math.max(first, end);
        }
        return first;
    }
}
