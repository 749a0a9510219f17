package org.jsmesh.encode;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.Sizes;

/**
 * An encoded mesh. Its bytes are in parts, so that it may be larger than an array can be; images are among them as they
 * were given, not copied. Immutable and thread-safe.
 */
public final class EncodedArchive {
    private final List<ByteBuffer> parts; // over arrays
    private final long length;
    private final ArchiveHeader header;
    private final List<Note> notes;

    /**
     * Takes an archive that was encoded before.
     *
     * @param parts all bytes of the file in their order, over arrays, which are shared; they must not change
     * @param header read from them
     * @param notes see {@link #notes()}
     */
    public EncodedArchive(List<ByteBuffer> parts, ArchiveHeader header, List<Note> notes) {
        this.parts = List.copyOf(parts);
        length = parts.stream().mapToLong(ByteBuffer::remaining).sum();
        this.header = header;
        this.notes = List.copyOf(notes);
    }

    /** {@return the number of bytes of the whole archive file} */
    public long length() {
        return length;
    }

    /**
     * Writes the whole archive file.
     *
     * @param out is given all bytes, and stays open
     * @throws IOException when it takes them not
     */
    public void writeTo(OutputStream out) throws IOException {
        for (ByteBuffer part : parts) out.write(part.array(), part.arrayOffset() + part.position(), part.remaining());
    }

    /**
     * Reads the whole archive file from its first byte; nothing is copied before it is read.
     *
     * @return {@link #length} bytes; need not be closed
     */
    public InputStream open() {
        return new PartsStream(parts);
    }

    /**
     * Copies the whole archive file. It takes as much memory again as the archive does: where the bytes go to a stream,
     * use {@link #writeTo} or {@link #open}.
     *
     * @return its bytes
     * @throws IllegalStateException when an array cannot hold so many
     */
    public byte[] bytes() {
        if (length > Sizes.MOST)
            throw new IllegalStateException("the archive has " + length + " bytes, more than the " + Sizes.MOST
                    + " that an array holds. Write it to a stream (writeTo)");
        byte[] all = new byte[(int) length];
        int at = 0;
        for (ByteBuffer part : parts) {
            System.arraycopy(part.array(), part.arrayOffset() + part.position(), all, at, part.remaining());
            at += part.remaining();
        }
        return all;
    }

    /** {@return what the file says of itself} */
    public ArchiveHeader header() {
        return header;
    }

    /**
     * {@return what of the model was mended or lost, in the order in which it was found; the header has those of
     * losses}
     */
    public List<Note> notes() {
        return notes;
    }
}
