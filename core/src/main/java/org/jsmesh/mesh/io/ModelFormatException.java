package org.jsmesh.mesh.io;

import java.io.IOException;

/** A model file cannot be read: which file, where, why, and what to do about it. */
public final class ModelFormatException extends IOException {
    private static final long serialVersionUID = 1L;
    private final String file;
    private final String place;
    private final String reason;
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

    public String file() {
        return file;
    }

    public String place() {
        return place;
    }

    public String reason() {
        return reason;
    }

    public String remedy() {
        return remedy;
    }
}
