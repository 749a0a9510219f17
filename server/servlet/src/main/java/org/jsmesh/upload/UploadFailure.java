package org.jsmesh.upload;

/** A model that was sent cannot be encoded, in words for the sender. */
final class UploadFailure extends Exception {
    private static final long serialVersionUID = 1L;
    private final String remedy;

    /** The reason and the remedy are sentences for the sender, without a full stop. */
    UploadFailure(String reason, String remedy) {
        super(reason);
        this.remedy = remedy;
    }

    /** What the sender can do about it. */
    String remedy() {
        return remedy;
    }
}
