package org.jsmesh.upload;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The place of one upload: a folder of its own, so that no model finds the files of another. Its name says when it came and of which model it is; a file in it whose
 * name begins with {@value #BODY} says that it is whole.
 */
record Ticket(Path folder, String id) {
    static final String BODY = "model.";
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

    void delete() throws IOException {
        delete(folder);
    }

    static void delete(Path tree) throws IOException {
        if (!Files.exists(tree)) return;
        List<Path> all;
        try (Stream<Path> walk = Files.walk(tree)) {
            all = walk.sorted(Comparator.reverseOrder()).toList();
        }
        for (Path path : all) Files.deleteIfExists(path);
    }
}
