package org.jsmesh.session;

import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.Proof;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/** The parts of a decoder that a session needs. */
interface MeshStream {
    void feed(byte[] bytes, int offset, int length) throws MalformedStreamException;

    /** Null until header and index have arrived whole. */
    ArchiveHeader header();

    /** Batches applied; 0 until the header has arrived. */
    int batches();

    boolean isComplete();

    Mesh mesh();

    /**
     * The mesh when everything has arrived, in the order of the original if the archive holds it.
     *
     * @throws MalformedStreamException when the order is damaged
     */
    default Mesh original() throws MalformedStreamException {
        return mesh();
    }

    /** Compares the mesh and its images with the hashes in the header. */
    Proof prove(Mesh mesh);

    /** The decoder of archives. */
    static MeshStream ofArchive() {
        ArchiveDecoder decoder = new ArchiveDecoder();
        return new MeshStream() {
            @Override
            public void feed(byte[] bytes, int offset, int length) throws MalformedStreamException {
                decoder.feed(bytes, offset, length);
            }

            @Override
            public ArchiveHeader header() {
                return decoder.header();
            }

            @Override
            public int batches() {
                return header() == null ? 0 : decoder.batches();
            }

            @Override
            public boolean isComplete() {
                return decoder.isComplete();
            }

            @Override
            public Mesh mesh() {
                return decoder.mesh();
            }

            @Override
            public Mesh original() throws MalformedStreamException {
                return decoder.meshInOrder();
            }

            @Override
            public Proof prove(Mesh mesh) {
                return Proof.of(decoder.header(), mesh);
            }
        };
    }
}
