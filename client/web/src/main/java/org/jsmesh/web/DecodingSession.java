package org.jsmesh.web;

import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.ArchiveOpening;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.Proof;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.display.LiveMesh;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;

/** Decodes one archive and prepares it for drawing. Not thread-safe. */
final class DecodingSession {
    private final ArchiveDecoder decoder = new ArchiveDecoder();
    private Mesh mesh;
    private int meshBatches;
    private LiveMesh live;
    private boolean hasJumped;

    int feed(byte[] bytes) throws MalformedStreamException {
        decoder.feed(bytes, 0, bytes.length);
        return decoder.batches();
    }

    /** Decodes bytes up to the first batch that the first decoder lacks; it never takes the last one, which proves. */
    int feedFirst(byte[] bytes) throws MalformedStreamException {
        for (int at = 0; at < bytes.length; ) {
            int count = 1; // the length of the opening is not known yet
            if (decoder.opening() != null) {
                BatchIndex index = decoder.index();
                int batch = decoder.batches();
                boolean isLast = decoder.header() != null && batch == index.size() - 1;
                if (isLast || isForWhole(index.kind(batch))) return -1 - batch;
                count = (int) Math.min(index.end(batch) - decoder.received(), bytes.length - at);
            }
            decoder.feed(bytes, at, count);
            at += count;
        }
        return decoder.batches();
    }

    private static boolean isForWhole(BatchKind kind) {
        return kind == BatchKind.ATTRIBUTES || kind == BatchKind.REMAINDER || kind == BatchKind.ORDER;
    }

    /** What the first bytes say, or null until they have arrived. */
    ArchiveOpening opening() {
        return decoder.opening();
    }

    /** The header, or null until all of it has arrived. */
    ArchiveHeader header() {
        return decoder.header();
    }

    /** The index as far as it is known, or null until the opening has arrived. */
    BatchIndex index() {
        return decoder.index();
    }

    int batches() {
        return decoder.batches();
    }

    boolean isComplete() {
        return decoder.isComplete();
    }

    /** Brings the arrays to draw to what is decoded now. */
    LiveMesh refine() {
        if (decoder.batches() == 0) throw new WrongCallException("the base has not arrived yet");
        if (live == null)
            live = new LiveMesh(decoder.growing(), decoder.opening().materials());
        ArchiveHeader header = decoder.header();
        int all = header != null ? header.faces() : Integer.MAX_VALUE; // not known yet
        double cosine = CreaseAngle.cosine(decoder.faces(), decoder.index().faces(0), all);
        hasJumped = isComplete() && mesh().faceChannel(FaceChannel.SMOOTHING) != null;
        if (hasJumped) live.replace(mesh(), cosine);
        else live.update(cosine);
        return live;
    }

    /** Whether the arrays are others as a whole, so that nothing of a picture stays while they are replaced. */
    boolean hasJumped() {
        return hasJumped;
    }

    /** The arrays to draw; null before {@link #refine}. */
    LiveMesh live() {
        return live;
    }

    /** Writes the images that can be shown: see {@link ShownImages#write}. */
    void writeImages(Json json) {
        if (decoder.batches() > 0) new ShownImages(mesh()).write(json);
        else json.open('[').close(']');
    }

    /** The image at a place in that list, as a file that browsers read. */
    byte[] image(int index) {
        return new ShownImages(mesh()).file(index);
    }

    /** Writes how the original, once all of it has come, compares with the hashes of the header. */
    void writeProof(Json json) {
        if (!isComplete()) throw new WrongCallException("the last batch has not arrived yet");
        Proof proof = Proof.of(header(), mesh());
        json.open('{').key("meshSha256").text(proof.meshSha256());
        json.key("modelSha256").text(proof.modelSha256());
        json.key("difference").text(proof.difference()).close('}');
    }

    String sha256() {
        return MeshIdentity.sha256(mesh());
    }

    private Mesh mesh() {
        if (decoder.batches() == 0) throw new WrongCallException("the base has not arrived yet");
        if (mesh == null || meshBatches != decoder.batches()) {
            mesh = decoder.mesh();
            meshBatches = decoder.batches();
        }
        return mesh;
    }
}
