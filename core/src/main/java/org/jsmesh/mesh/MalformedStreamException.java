package org.jsmesh.mesh;

import java.io.IOException;

/** The bytes of an archive are not what its format allows. */
public final class MalformedStreamException extends IOException {
    private static final long serialVersionUID = 1L;
    /** Counted from the start of the archive; −1 when unknown. */
    private final long offset;

    /**
     * Says where an archive is not what its format allows.
     *
     * @param offset of the byte from the start of the archive, or −1 when unknown
     * @param reason what is wrong there
     */
    public MalformedStreamException(long offset, String reason) {
        super(offset < 0 ? reason : reason + " (byte " + offset + ")");
        this.offset = offset;
    }

    /** {@return the byte from the start of the archive that is wrong, or −1 when it is unknown} */
    public long offset() {
        return offset;
    }
}
