package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;

/** Keeps what is written from taking the place of something that must stay. */
public final class OutputFiles {
    private OutputFiles() {}

    /**
     * A file may be replaced; a folder, a device or a pipe may not, nor a link that leads nowhere.
     *
     * @throws FileSystemException when something is there that is no regular file
     */
    public static void requireReplaceable(Path target) throws FileSystemException {
        if (Files.isRegularFile(target) || !Files.exists(target, LinkOption.NOFOLLOW_LINKS)) return;
        String what = Files.isDirectory(target) ? "is a folder" : "is there and is no regular file";
        throw new FileSystemException(target.toString(), null, what + ", nothing is written. Choose another place");
    }

    /** True when both paths lead to one file that exists, through whatever links. */
    public static boolean areSame(Path a, Path b) {
        try {
            return Files.isSameFile(a, b);
        } catch (IOException e) {
            // One of them is not there yet.
            return false;
        }
    }

    /** The place itself, or behind a link the file that it leads to: the link stays. */
    static Path behindLinks(Path target) throws IOException {
        requireReplaceable(target);
        return Files.isSymbolicLink(target) ? target.toRealPath() : target;
    }
}
