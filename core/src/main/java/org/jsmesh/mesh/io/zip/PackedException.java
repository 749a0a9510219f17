package org.jsmesh.mesh.io.zip;

import java.io.IOException;

/** Packed bytes cannot be unpacked: why, and what to do about it. */
public final class PackedException extends IOException {
    private static final long serialVersionUID = 1L;

    /** What to do about it. */
    private final String remedy;

    /**
     * Says why and what to do.
     *
     * @param reason without a full stop
     * @param remedy without a full stop
     */
    public PackedException(String reason, String remedy) {
        super(reason);
        this.remedy = remedy;
    }

    /** {@return what is wrong, without a full stop} */
    public String reason() {
        return getMessage();
    }

    /** {@return what to do about it, without a full stop} */
    public String remedy() {
        return remedy;
    }
}
