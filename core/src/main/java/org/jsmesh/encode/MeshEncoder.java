package org.jsmesh.encode;

import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** Encodes meshes as archives. Thread-safe. */
public final class MeshEncoder {
    private final EncoderSettings settings;

    public MeshEncoder(EncoderSettings settings) {
        this.settings = settings;
    }

    /**
     * @throws IllegalArgumentException when the mesh has no face
     * @throws java.util.concurrent.CancellationException when the listener cancels
     */
    public EncodedArchive encode(Mesh mesh, ProgressListener progress) {
        throw new UnsupportedOperationException("not yet: " + settings);
    }
}
