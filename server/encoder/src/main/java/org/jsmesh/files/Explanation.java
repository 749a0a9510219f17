package org.jsmesh.files;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import org.jsmesh.memory.HeapShortageException;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.io.ModelFormatException;

/**
 * A failure in words for people. Code that encodes, serves or receives models catches exceptions and asks this class
 * for the words, so that one failure has one wording. Only the remedy depends on the reader.
 *
 * @param place the file, with line or byte where that is known; or what was being worked on; may be empty
 * @param reason what is wrong, on one line
 * @param remedy what the reader can do about it; may be empty
 */
public record Explanation(String place, String reason, String remedy) {
    /** Who reads it. */
    public enum Audience {
        /** A reader who runs a command on their own files. */
        COMMAND,
        /** A reader who runs a server or visits it. The words say nothing of the server's paths. */
        SERVER,
        /** A reader who sent a model to a server. Likewise; all that they can do is send another model. */
        SENDER
    }

    /**
     * Words for a reader who runs a command.
     *
     * @param about the file or address that was being worked on, for failures that name none, or null
     * @param failure what was thrown
     * @return place, reason and remedy
     */
    public static Explanation of(Object about, Throwable failure) {
        return of(about, failure, Audience.COMMAND);
    }

    /**
     * Explains a failure.
     *
     * @param about what was being worked on; beyond commands it begins a sentence, as {@code the model} does
     * @param failure what was thrown
     * @param audience who reads it, for the remedy
     * @return place, reason and remedy
     */
    public static Explanation of(Object about, Throwable failure, Audience audience) {
        String place = about == null ? "" : about.toString();
        boolean isCommand = audience == Audience.COMMAND;
        if (failure instanceof ModelFormatException e) {
            if (isCommand) {
                String where = e.place().isEmpty() ? e.file() : e.file() + ", " + e.place();
                return new Explanation(where, oneLine(e.reason()), oneLine(e.remedy()));
            }
            String where = e.place().isEmpty() ? "" : " (" + e.place() + ")";
            return new Explanation(place, "cannot be read: " + oneLine(e.reason()) + where, oneLine(e.remedy()));
        }
        if (failure instanceof MalformedStreamException) {
            String reason = (isCommand ? "" : "is ") + "not a whole archive: " + oneLine(failure.getMessage());
            return new Explanation(
                    place,
                    reason,
                    isCommand
                            ? "Encode the model or fetch the archive again"
                            : "encode the model again with 'jsm encode'");
        }
        if (failure instanceof OutOfMemoryError) return outOfMemory(place, audience);
        if (failure instanceof HeapShortageException e)
            return new Explanation(place, e.reason(), memoryRemedy(audience, e.remedy()));
        if (failure instanceof StackOverflowError)
            return new Explanation(place, "is nested too deeply", "Export the model anew");
        if (failure instanceof IllegalArgumentException) {
            Explanation e = divided(place, failure.getMessage());
            if (isCommand) return e;
            return new Explanation(
                    place, "cannot be encoded: " + e.reason, e.remedy.isEmpty() ? "repair the model file" : e.remedy);
        }
        // The cause may speak of paths of the server, which are nobody's business.
        if (audience == Audience.SERVER) return new Explanation(place, "could not be prepared", "see the server's log");
        if (audience == Audience.SENDER)
            return new Explanation(place, "could not be encoded by the server", "tell the server's owner");
        if (failure instanceof FileSystemException e) return fileSystem(place, e);
        if (failure instanceof IOException) return divided(place, failure.getMessage());
        return new Explanation(
                place, oneLine(failure.toString()), "This is a fault in jSM: please report it with the file");
    }

    private static Explanation outOfMemory(String place, Audience audience) {
        long megabytes = Runtime.getRuntime().maxMemory() >> 20;
        return new Explanation(
                place,
                "needs more memory than the " + megabytes + " MiB allowed",
                memoryRemedy(audience, "Give Java more, for instance -Xmx" + Math.max(2, megabytes / 512) + "g"));
    }

    private static String memoryRemedy(Audience audience, String ofCommand) {
        return switch (audience) {
            case COMMAND -> ofCommand;
            case SERVER -> "encode it with 'jsm encode' on a larger machine, or give the server more memory (-Xmx)";
            case SENDER -> "send a smaller model";
        };
    }

    private static Explanation fileSystem(String about, FileSystemException e) {
        String file = e.getFile() == null ? about : e.getFile();
        if (e instanceof NoSuchFileException) return new Explanation(file, "no such file", "Check the path");
        if (e instanceof AccessDeniedException) return new Explanation(file, "access denied", "Check the permissions");
        if (e.getReason() != null) return divided(file, e.getReason());
        if (e instanceof FileAlreadyExistsException || e instanceof NotDirectoryException)
            return new Explanation(file, "is a file, not a folder", "Choose another place");
        return new Explanation(file, oneLine(e.toString()), "");
    }

    /** Messages of exceptions are a reason, and behind it, in a sentence of its own, the remedy. */
    private static Explanation divided(String place, String message) {
        String text = oneLine(message);
        if (text.endsWith(".")) text = text.substring(0, text.length() - 1);
        int end = text.lastIndexOf(". ");
        return end < 0
                ? new Explanation(place, text, "")
                : new Explanation(place, text.substring(0, end), text.substring(end + 2));
    }

    private static String oneLine(String text) {
        return text == null ? "no reason given" : text.strip().replaceAll("\\s*\\R\\s*", " ");
    }

    /** {@return what is wrong as one sentence without its full stop, such as {@code the model cannot be read: …}} */
    public String sentence() {
        return place.isEmpty() ? reason : place + " " + reason;
    }

    /** All on one line, as commands print it: {@code chair.obj, line 3: … . Remove this line.} */
    @Override
    public String toString() {
        String line = (place.isEmpty() ? "" : place + ": ") + reason + ".";
        return remedy.isEmpty() ? line : line + " " + remedy + ".";
    }
}
