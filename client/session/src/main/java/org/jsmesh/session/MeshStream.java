package org.jsmesh.session;

import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.Proof;
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

    /**
     * Follows the mesh by what batches change, from the first byte on: to be called before any is fed. Null where the
     * decoder does not offer it.
     */
    default LiveFollower follow() {
        return null;
    }
}
