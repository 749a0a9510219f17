package org.jsmesh.upload;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jsmesh.files.AtomicFiles;

/**
 * The place of one upload: a folder of its own, so that no model finds the files of another. Its name says when the
 * upload came and which model it is. A file in it whose name begins with {@value #BODY} says that the upload is whole.
 */
record Ticket(Path folder, String id) {
    static final String BODY = "model.";
    private static final String ATTEMPTS = "attempts";
    private static final Pattern NAME = Pattern.compile("\\d{19}-([a-z0-9-]+)");

    /** @param number that grows */
    static Ticket of(Path spool, long number, String id) {
        return new Ticket(spool.resolve(String.format(java.util.Locale.ROOT, "%019d-%s", number, id)), id);
    }

    /** The ticket of a folder in the spool, or null. */
    static Ticket of(Path folder) {
        Matcher name = NAME.matcher(String.valueOf(folder.getFileName()));
        return name.matches() ? new Ticket(folder, name.group(1)) : null;
    }

    Path body(String extension) {
        return folder.resolve(BODY + extension);
    }

    /** The received file, or null while it is not whole. */
    Path received() throws IOException {
        if (!Files.isDirectory(folder)) return null;
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, BODY + "*")) {
            for (Path file : files) return file;
        }
        return null;
    }

    /** Where the archive is written. */
    Path archive() {
        return folder.resolve("archive.jsm");
    }

    /**
     * Notes on disk that an encoding begins, so that a model that brings the whole server down does not do so at each
     * start.
     *
     * @return number of times that it was begun, this time included
     */
    int attempt() throws IOException {
        byte[] marks = attempts();
        AtomicFiles.write(folder.resolve(ATTEMPTS), Arrays.copyOf(marks, marks.length + 1));
        return marks.length + 1;
    }

    /** Makes the last attempt not count. */
    void takeBackAttempt() throws IOException {
        byte[] marks = attempts();
        if (marks.length > 0) AtomicFiles.write(folder.resolve(ATTEMPTS), Arrays.copyOf(marks, marks.length - 1));
    }

    /** One byte for each. */
    private byte[] attempts() throws IOException {
        Path file = folder.resolve(ATTEMPTS);
        return Files.exists(file) ? Files.readAllBytes(file) : new byte[0];
    }

    void delete() throws IOException {
        delete(folder);
    }

    static void delete(Path tree) throws IOException {
        if (!Files.exists(tree)) return;
        List<Path> all;
        try (Stream<Path> walk = Files.walk(tree)) {
            all = walk.sorted(Comparator.reverseOrder()).toList();
        } catch (UncheckedIOException e) {
            throw e.getCause();
        }
        for (Path path : all) Files.deleteIfExists(path);
    }
}
