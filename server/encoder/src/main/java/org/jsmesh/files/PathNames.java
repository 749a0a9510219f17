package org.jsmesh.files;

import java.io.File;
import java.nio.file.FileSystemException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/**
 * Names of files that the locale of the process cannot hold. Under the POSIX locale Java takes names for ASCII: a
 * folder lists a file named in another script, but the text of its name leads nowhere, and no archive can be named
 * after it.
 */
public final class PathNames {
    /** What to do about such a name. */
    public static final String REMEDY = "Set a locale that can, such as LC_ALL=C.UTF-8, and start again";

    private PathNames() {}

    /**
     * Tells whether the names of a path can be written as text and read again.
     *
     * @param path as a folder lists it
     * @return false when it can be opened, but neither named nor be the pattern of another name
     */
    public static boolean areRepresentable(Path path) {
        try {
            path.getFileSystem().getPath(path.toString());
            return true;
        } catch (InvalidPathException e) {
            return false;
        }
    }

    /**
     * Says why a file is not read.
     *
     * @param path that is not representable
     * @return names it by its address, whose characters every locale holds
     */
    public static FileSystemException skipped(Path path) {
        String reason =
                "is skipped, because the locale of this process cannot hold its name (% stands before a byte of "
                        + "it in hexadecimal). " + REMEDY;
        return new FileSystemException(path.toUri().toString(), null, reason);
    }

    /**
     * Says why a file is not written.
     *
     * @param name that a model or an archive gives it
     * @return names it
     */
    static FileSystemException notWritten(String name) {
        return new FileSystemException(name, null, "the locale of this process cannot hold this file name. " + REMEDY);
    }

    /**
     * Tells a file's name, whatever the locale.
     *
     * @param path as a folder lists it
     * @return the last of its names; its bytes as UTF-8 when it is not representable
     */
    public static String name(Path path) {
        if (areRepresentable(path)) return String.valueOf(path.getFileName());
        String whole = path.toUri().getPath();
        String file = whole.endsWith("/") ? whole.substring(0, whole.length() - 1) : whole;
        return file.substring(file.lastIndexOf('/') + 1);
    }

    /**
     * Writes a path the same way on every system.
     *
     * @param path a relative path
     * @return its names with slashes between them
     */
    public static String withSlashes(Path path) {
        return path.toString().replace(File.separatorChar, '/');
    }
}
