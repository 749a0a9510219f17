package org.jsmesh.session;

import java.util.Arrays;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.decode.FaceLevels;
import org.jsmesh.display.CreaseAngle;
import org.jsmesh.display.LiveMesh;
import org.jsmesh.display.LiveStep;
import org.jsmesh.mesh.FaceChannel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/** Follows a decoder by what its batches change. */
final class LiveFollower {
    private final ArchiveDecoder decoder;
    private final FaceLevels faceLevels;
    private LiveMesh mesh;
    private int shown; // batches
    private int knownVertices;
    private int knownFaces;

    LiveFollower(ArchiveDecoder decoder) {
        this.decoder = decoder;
        faceLevels = new FaceLevels(decoder);
    }

    /** Feeds the decoder. */
    void feed(byte[] bytes, int offset, int length) throws MalformedStreamException {
        faceLevels.feed(bytes, offset, length);
    }

    /** What has changed since the last call; the header must have arrived. */
    MeshStep step(SessionProgress progress, Runnable taken) {
        if (mesh == null)
            mesh = new LiveMesh(decoder.growing(), decoder.opening().materials());
        ArchiveHeader header = decoder.header();
        double cosine = CreaseAngle.cosine(decoder.faces(), header.batches().faces(0), header.faces());
        Mesh whole = decoder.isComplete() || bringsImages(header.batches()) ? decoder.mesh() : null;
        // Creases between smoothing groups are known at the end alone.
        boolean isJump = decoder.isComplete() && whole.faceChannel(FaceChannel.SMOOTHING) != null;
        if (isJump) mesh.replace(whole, cosine);
        else mesh.update(cosine);
        LiveStep live = LiveStep.of(mesh, knownVertices, isJump);
        int[] places = isJump ? all(live.places()) : new int[decoder.growing().faceNumbers() - knownFaces];
        byte[] levels = new byte[places.length];
        if (isJump) Arrays.fill(levels, (byte) header.batches().level(decoder.batches() - 1));
        int count = isJump ? places.length : findNew(places, levels);
        knownVertices = live.vertices();
        knownFaces = decoder.growing().faceNumbers();
        shown = decoder.batches();
        return new MeshStep(
                live,
                Arrays.copyOf(places, count),
                Arrays.copyOf(levels, count),
                whole,
                decoder.isComplete(),
                progress,
                taken);
    }

    private boolean bringsImages(BatchIndex index) {
        for (int b = shown; b < decoder.batches(); b++)
            if (index.kind(b) == BatchKind.TEXTURE || index.kind(b) == BatchKind.PREVIEW) return true;
        return false;
    }

    private int findNew(int[] places, byte[] levels) {
        int count = 0;
        for (int face = knownFaces; face < knownFaces + places.length; face++) {
            int place = mesh.place(face);
            if (place < 0) continue;
            places[count] = place;
            levels[count++] = (byte) faceLevels.level(face);
        }
        return count;
    }

    private static int[] all(int count) {
        int[] places = new int[count];
        for (int i = 0; i < count; i++) places[i] = i;
        return places;
    }
}
