package org.jsmesh.mesh;

import java.io.IOException;

/** The bytes of an archive are not what its format allows. */
public final class MalformedStreamException extends IOException {
    private static final long serialVersionUID = 1L;
    private final long offset;

    /**
     * @param offset of the byte from the start of the archive, or −1 when unknown
     * @param reason what is wrong there
     */
    public MalformedStreamException(long offset, String reason) {
        super(offset < 0 ? reason : reason + " (byte " + offset + ")");
        this.offset = offset;
    }

    public long offset() {
        return offset;
    }
}
