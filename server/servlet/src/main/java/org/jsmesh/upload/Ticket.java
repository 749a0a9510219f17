package org.jsmesh.upload;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jsmesh.files.AtomicFiles;

/**
 * The place of one upload: a folder of its own, so that no model finds the files of another. Its name says when the
 * upload came and which model it is, a file in it who sends it. A file in it whose name begins with {@value #BODY} says
 * that the upload is whole.
 */
record Ticket(Path folder, String id, Sender sender) {
    static final String BODY = "model.";
    private static final String ATTEMPTS = "attempts";
    private static final String SENDER = "sender";
    /** Who sent what an older server has left. */
    private static final Sender SOMEBODY = new Sender("0".repeat(64), Long.MAX_VALUE, Integer.MAX_VALUE);

    private static final Pattern WORDS = Pattern.compile("([0-9a-f]{64}) (\\d{1,19}) (\\d{1,10})");
    private static final Pattern NAME = Pattern.compile("\\d{19}-([a-z0-9-]+)");

    /** @param number that grows */
    static Ticket of(Path spool, long number, String id, Sender sender) {
        return new Ticket(spool.resolve(String.format(Locale.ROOT, "%019d-%s", number, id)), id, sender);
    }

    /** The ticket of a folder in the spool, or null. */
    static Ticket of(Path folder) throws IOException {
        Matcher name = NAME.matcher(String.valueOf(folder.getFileName()));
        if (!name.matches() || !Files.isDirectory(folder)) return null;
        Path sender = folder.resolve(SENDER);
        if (!Files.exists(sender)) return new Ticket(folder, name.group(1), SOMEBODY);
        Matcher words = WORDS.matcher(Files.readString(sender).strip());
        if (!words.matches()) return null; // it was cut, and the model did not come
        Sender known = new Sender(words.group(1), Long.parseLong(words.group(2)), Integer.parseInt(words.group(3)));
        return new Ticket(folder, name.group(1), known);
    }

    /** Makes the folder, and notes there who sends. */
    void begin() throws IOException {
        Files.createDirectories(folder);
        String words = sender.key() + ' ' + sender.mostBytes() + ' ' + sender.mostModels() + '\n';
        AtomicFiles.write(folder.resolve(SENDER), words.getBytes(StandardCharsets.US_ASCII));
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
