package org.jsmesh.mesh.io;

import java.io.IOException;

/** A model file cannot be read: which file, where, why, and what to do about it. */
public final class ModelFormatException extends IOException {
    private static final long serialVersionUID = 1L;
    /** Name of the file. */
    private final String file;

    /** Line or byte, in words. */
    private final String place;

    /** What is wrong there. */
    private final String reason;

    /** What to do about it. */
    private final String remedy;

    /**
     * @param file name of the file
     * @param place line or byte offset, for example {@code line 12} or {@code byte 84}; empty when the whole file is
     *     meant
     * @param reason what is wrong there
     * @param remedy what the user can do
     */
    public ModelFormatException(String file, String place, String reason, String remedy) {
        super(file + (place.isEmpty() ? "" : ", " + place) + ": " + reason + ". " + remedy + ".");
        this.file = file;
        this.place = place;
        this.reason = reason;
        this.remedy = remedy;
    }

    /** {@return the name of the file that cannot be read} */
    public String file() {
        return file;
    }

    /** {@return the line or the byte where it is wrong, in words} */
    public String place() {
        return place;
    }

    /** {@return what is wrong there} */
    public String reason() {
        return reason;
    }

    /** {@return what to do about it} */
    public String remedy() {
        return remedy;
    }
}
