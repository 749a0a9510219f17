package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;

/** Keeps output from replacing something that must stay. */
public final class OutputFiles {
    private OutputFiles() {}

    /**
     * Checks that the output may be written: it may replace a file, but no folder, device or pipe, and no link that
     * leads nowhere.
     *
     * @param target the place for the output; nothing needs to be there
     * @throws FileSystemException when something other than a regular file is there
     */
    public static void requireReplaceable(Path target) throws FileSystemException {
        if (Files.isRegularFile(target) || !Files.exists(target, LinkOption.NOFOLLOW_LINKS)) return;
        String what = Files.isDirectory(target) ? "is a folder" : "is there and is no regular file";
        throw new FileSystemException(target.toString(), null, what + ", nothing is written. Choose another place");
    }

    /**
     * Tells whether two paths lead to one file that exists, through whatever links.
     *
     * @param a one path
     * @param b the other path
     * @return true when they do
     */
    public static boolean areSame(Path a, Path b) {
        try {
            return Files.isSameFile(a, b);
        } catch (IOException e) {
            // One of them does not exist yet.
            return false;
        }
    }

    /** The place itself, or the file that a link leads to, so that the link stays. */
    static Path behindLinks(Path target) throws IOException {
        requireReplaceable(target);
        return Files.isSymbolicLink(target) ? target.toRealPath() : target;
    }
}
