package org.jsmesh.app.paper;

import java.io.IOException;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.encode.Simplifier;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** An archive of one thread, without a poster, as the paper's files have none. */
record Encoded(EncodedArchive archive) {
    /** By the default simplifier. */
    static Encoded of(Mesh mesh) {
        return of(mesh, EncoderSettings.defaults());
    }

    /** By the paper's. */
    static Encoded of(Mesh mesh, Levels levels) {
        return of(
                mesh,
                EncoderSettings.defaults()
                        .withSimplifier(Simplifier.PAPER)
                        .withLevels(levels.thresholds())
                        .withBaseFaces(levels.faces()));
    }

    private static Encoded of(Mesh mesh, EncoderSettings simplified) {
        EncoderSettings settings = simplified.withPoster(false);
        return new Encoded(new MeshEncoder(settings).encode(mesh, ProgressListener.NONE));
    }

    BatchIndex index() {
        return archive.header().batches();
    }

    byte[] bytes() {
        return archive.bytes();
    }

    int baseFaces() {
        return index().faces(0);
    }

    int baseVertices() {
        return index().vertices(0);
    }

    long baseBytes() {
        return index().end(0);
    }

    int vertices() {
        return index().vertices(index().size() - 1);
    }

    /** Patches: a vertex comes with each. */
    int patches() {
        return vertices() - baseVertices();
    }

    /** All that comes after the base, for each patch. */
    double bytesPerPatch() {
        return (double) (bytes().length - baseBytes()) / patches();
    }

    /** What is shown as soon as there are so many faces. */
    Mesh withFaces(int faces) throws IOException {
        int batch = 0;
        while (batch + 1 < index().size() && index().faces(batch) < faces) batch++;
        return ArchiveFile.of(bytes()).meshAfter(batch, ProgressListener.NONE);
    }
}
