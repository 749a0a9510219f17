package org.jsmesh.session;

import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.Proof;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/** The decoder of archives. */
final class DecodedArchive implements MeshStream {
    private final ArchiveDecoder decoder = new ArchiveDecoder();
    private LiveFollower follower;

    @Override
    public LiveFollower follow() {
        follower = new LiveFollower(decoder);
        return follower;
    }

    @Override
    public void feed(byte[] bytes, int offset, int length) throws MalformedStreamException {
        if (follower == null) decoder.feed(bytes, offset, length);
        else follower.feed(bytes, offset, length);
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
}
