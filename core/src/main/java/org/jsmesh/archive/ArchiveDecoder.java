package org.jsmesh.archive;

import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/**
 * Decodes an archive as its bytes arrive, in any portions. After every complete batch the mesh is valid and can be shown. Not thread-safe.
 */
public final class ArchiveDecoder {
    /**
     * Takes the next bytes of the file and applies every batch that they complete.
     *
     * @throws MalformedStreamException when the bytes are not an archive; the decoder stays at the last good batch and takes no more
     */
    public void feed(byte[] bytes, int offset, int length) throws MalformedStreamException {
        throw new UnsupportedOperationException("not yet");
    }

    /** Bytes fed so far. */
    public long received() {
        throw new UnsupportedOperationException("not yet");
    }

    /** The header, or null until it has arrived. */
    public ArchiveHeader header() {
        throw new UnsupportedOperationException("not yet");
    }

    /** Batches applied: 0 until the base has arrived. */
    public int batches() {
        throw new UnsupportedOperationException("not yet");
    }

    /** True when every batch is applied. */
    public boolean isComplete() {
        throw new UnsupportedOperationException("not yet");
    }

    /** A snapshot of the mesh after the batches applied so far, with the textures that have arrived whole. */
    public Mesh mesh() {
        throw new UnsupportedOperationException("not yet");
    }
}
