package org.jsmesh.desktop.dialog;

import java.nio.file.Path;
import java.util.List;

/** The questions that a window asks. On the event dispatch thread; an answer of null, or of nothing, calls it off. */
public interface Dialogs {
    /**
     * Asks for files to open.
     *
     * @param folder to look in first, or null
     * @return the files
     */
    List<Path> open(Path folder);

    /**
     * Asks for an address to open.
     *
     * @param suggestion to begin with
     * @return what was typed
     */
    String address(String suggestion);

    /**
     * Asks for a file to save a model into.
     *
     * @param title of the question
     * @param suggestion with its extension
     * @param isArchive whether it is an archive, or else a model of any format
     * @return the file, which may be replaced
     */
    Path save(String title, Path suggestion, boolean isArchive);

    /**
     * Asks for a PNG file to save a picture into.
     *
     * @param suggestion with its extension
     * @return the file, which may be replaced
     */
    Path savePicture(Path suggestion);

    /**
     * Says something that needs no answer.
     *
     * @param title above it
     * @param words to be said
     */
    void tell(String title, String words);
}
