package org.jsmesh.mesh;

/** A model has more of something than arrays hold. The message says of what, how many they hold, and what to do. */
public final class TooLargeException extends IllegalArgumentException {
    private static final long serialVersionUID = 1L;

    /** What to do about it. */
    public static final String REMEDY = "Cut the model into parts";

    private final String reason;

    /**
     * Says what there is too much of.
     *
     * @param count how many there are
     * @param what they are, for instance {@code faces}
     * @param most how many there may be
     */
    public TooLargeException(long count, String what, long most) {
        this("there are " + count + " " + what + ", more than the " + most + " that fit into memory as one model");
    }

    private TooLargeException(String reason) {
        super(reason + ". " + REMEDY);
        this.reason = reason;
    }

    /** {@return the message without the remedy} */
    public String reason() {
        return reason;
    }
}
