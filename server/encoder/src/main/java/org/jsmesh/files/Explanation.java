package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.io.ModelFormatException;

/** Says a failure in one line for people: what, where, remedy. */
public final class Explanation {
    private Explanation() {}

    /** @param about the file or address that was being worked on, for failures that name none, or null */
    public static String of(Object about, Throwable failure) {
        if (failure instanceof ModelFormatException) return oneLine(failure.getMessage());
        if (failure instanceof MalformedStreamException) {
            return place(about) + "not a whole archive: " + oneLine(failure.getMessage())
                    + ". Encode the model or fetch the archive again.";
        }
        if (failure instanceof FileSystemException e) return fileSystem(about, e);
        if (failure instanceof OutOfMemoryError) {
            long megabytes = Runtime.getRuntime().maxMemory() >> 20;
            return place(about) + "needs more memory than the " + megabytes
                    + " MiB allowed. Give Java more, for instance -Xmx" + Math.max(2, megabytes / 512) + "g.";
        }
        if (failure instanceof IOException || failure instanceof IllegalArgumentException)
            return place(about) + sentence(oneLine(failure.getMessage()));
        return place(about) + oneLine(failure.toString()) + ". This is a fault in jSM: please report it with the file.";
    }

    private static String place(Object about) {
        return about == null ? "" : about + ": ";
    }

    private static String fileSystem(Object about, FileSystemException e) {
        String file = e.getFile() == null ? String.valueOf(about) : e.getFile();
        if (e instanceof NoSuchFileException) return file + ": no such file. Check the path.";
        if (e instanceof AccessDeniedException) return file + ": access denied. Check the permissions.";
        if (e.getReason() == null && (e instanceof FileAlreadyExistsException || e instanceof NotDirectoryException))
            return file + ": is a file, not a folder. Choose another place.";
        return file + ": " + (e.getReason() == null ? oneLine(e.toString()) : e.getReason()) + ".";
    }

    private static String sentence(String text) {
        return text.endsWith(".") ? text : text + ".";
    }

    private static String oneLine(String text) {
        return text == null ? "no reason given" : text.strip().replaceAll("\\s*\\R\\s*", " ");
    }
}
