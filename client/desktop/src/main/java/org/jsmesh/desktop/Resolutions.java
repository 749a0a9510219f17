package org.jsmesh.desktop;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.session.ArrivedBytes;

/**
 * Earlier resolutions of an archive, decoded once more from the bytes that have arrived. Goes on from the one before
 * where it can, and keeps the meshes that were shown last. Used by one thread at a time.
 */
final class Resolutions {
    /** Faces of all meshes that are kept, which is about 200 MB. */
    private static final long MOST_FACES = 2_000_000;

    private final ArrivedBytes arrived;
    private final byte[] portion = new byte[1 << 16];
    private final Map<Integer, Mesh> kept = new LinkedHashMap<>(16, .75f, true);
    private ArchiveDecoder decoder = new ArchiveDecoder();
    private long fed;
    private long keptFaces;

    Resolutions(ArrivedBytes arrived) {
        this.arrived = arrived;
    }

    /**
     * The mesh after a batch that has arrived.
     *
     * @param index of the whole archive
     * @throws MalformedStreamException when a batch up to that one is damaged
     */
    Mesh after(int batch, BatchIndex index) throws MalformedStreamException {
        Mesh known = kept.get(batch);
        if (known != null) return known;
        if (index.end(batch) > arrived.length())
            throw new IllegalArgumentException("batch " + batch + " has not arrived");
        if (fed > index.end(batch)) {
            decoder = new ArchiveDecoder();
            fed = 0;
        }
        while (fed < index.end(batch)) {
            int count = arrived.copy(fed, portion, (int) Math.min(portion.length, index.end(batch) - fed));
            decoder.feed(portion, 0, count);
            fed += count;
        }
        Mesh mesh = decoder.mesh();
        keep(batch, mesh);
        return mesh;
    }

    private void keep(int batch, Mesh mesh) {
        kept.put(batch, mesh);
        keptFaces += mesh.faces();
        var oldest = kept.entrySet().iterator();
        while (keptFaces > MOST_FACES && kept.size() > 1) {
            keptFaces -= oldest.next().getValue().faces();
            oldest.remove();
        }
    }
}
