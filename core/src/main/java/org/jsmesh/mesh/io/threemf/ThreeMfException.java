package org.jsmesh.mesh.io.threemf;

/** A 3MF package cannot be read: where, why, and what to do about it. */
public final class ThreeMfException extends Exception {
    private static final long serialVersionUID = 1L;

    /** Part and line, in words. */
    private final String place;

    /** What to do about it. */
    private final String remedy;

    ThreeMfException(String place, String reason, String remedy) {
        super(reason);
        this.place = place;
        this.remedy = remedy;
    }

    /** {@return the part and the line where it is wrong, in words; empty when the whole package is meant} */
    public String place() {
        return place;
    }

    /** {@return what is wrong there} */
    public String reason() {
        return getMessage();
    }

    /** {@return what the user can do} */
    public String remedy() {
        return remedy;
    }
}
