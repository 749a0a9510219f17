package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.files.ArchiveFile;

/** Reads archives for the commands. */
final class ArchiveInput {
    private ArchiveInput() {}

    static ArchiveFile read(Path file) throws CommandFailure {
        try {
            return ArchiveFile.read(file);
        } catch (IOException e) {
            throw new CommandFailure(file, e);
        }
    }

    static ArchiveFile readWhole(Path file) throws CommandFailure {
        ArchiveFile archive = read(file);
        if (!archive.isWhole()) throw new CommandFailure(cut(file, archive));
        return archive;
    }

    /** Says that a file is cut and what to do. */
    static String cut(Path file, ArchiveFile archive) {
        int there = archive.batches();
        String atLeast = archive.header() != null ? "" : "at least ";
        String remedy = there == 0 ? "" : ", or decode what is there with --batch " + (there - 1);
        return file + ": the file is cut: " + archive.length() + " of " + atLeast
                + archive.index().archiveBytes() + " bytes, " + there + " of " + atLeast
                + archive.index().size() + " batches. Fetch the rest" + remedy + ".";
    }
}
