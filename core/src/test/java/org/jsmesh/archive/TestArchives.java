package org.jsmesh.archive;

import java.util.List;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncodedArchive;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.encode.Quality;
import org.jsmesh.encode.Simplifier;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** Encodes and decodes in one call. */
public final class TestArchives {
    private TestArchives() {}

    public static EncodedArchive encode(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults()).encode(mesh, ProgressListener.NONE);
    }

    /** Encodes with a base of a few faces, so that small meshes have passes too. */
    public static EncodedArchive encodeFar(Mesh mesh) {
        return new MeshEncoder(EncoderSettings.defaults().withBaseFaces(4)).encode(mesh, ProgressListener.NONE);
    }

    /** The same with predictors that take less time. */
    public static EncodedArchive encodeLightly(Mesh mesh) {
        EncoderSettings settings = EncoderSettings.defaults().withBaseFaces(4).withQuality(Quality.FAST);
        return new MeshEncoder(settings).encode(mesh, ProgressListener.NONE);
    }

    /** Encodes by the paper's method, as far as it goes. */
    public static EncodedArchive encodeByPaper(Mesh mesh) {
        EncoderSettings settings =
                EncoderSettings.defaults().withSimplifier(Simplifier.PAPER).withLevels(List.of(.1, .5, 10.0));
        return new MeshEncoder(settings).encode(mesh, ProgressListener.NONE);
    }

    /** Encodes with a base of a few faces, holding the order of the mesh's arrays. */
    public static EncodedArchive encodeInOrder(Mesh mesh) {
        EncoderSettings settings = EncoderSettings.defaults().withBaseFaces(4).withKeepOrder(true);
        return new MeshEncoder(settings).encode(mesh, ProgressListener.NONE);
    }

    public static ArchiveDecoder decode(byte[] bytes, int length) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(bytes, 0, length);
        return decoder;
    }

    /** The mesh of a whole archive. */
    public static Mesh mesh(byte[] bytes) throws MalformedStreamException {
        return decode(bytes, bytes.length).mesh();
    }
}
