package org.jsmesh.desktop;

import java.util.LinkedHashMap;
import java.util.Map;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.decode.FaceLevels;
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

    /**
     * A resolution.
     *
     * @param mesh as it was after a batch
     * @param levels in which each of its faces came; empty for that of the last batch, whose faces have another order
     */
    record Resolution(Mesh mesh, byte[] levels) {}

    private static final byte[] UNKNOWN = {};

    private final ArrivedBytes arrived;
    private final byte[] portion = new byte[1 << 16];
    private final Map<Integer, Resolution> kept = new LinkedHashMap<>(16, .75f, true);
    private ArchiveDecoder decoder = new ArchiveDecoder();
    private FaceLevels feeding = new FaceLevels(decoder);
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
    Resolution after(int batch, BatchIndex index) throws MalformedStreamException {
        Resolution known = kept.get(batch);
        if (known != null) return known;
        if (index.end(batch) > arrived.length())
            throw new IllegalArgumentException("batch " + batch + " has not arrived");
        if (fed > index.end(batch)) {
            decoder = new ArchiveDecoder();
            feeding = new FaceLevels(decoder);
            fed = 0;
        }
        while (fed < index.end(batch)) {
            int count = arrived.copy(fed, portion, (int) Math.min(portion.length, index.end(batch) - fed));
            long next = fed + count;
            // A decoder that fails within a portion is of no use any more.
            fed = Long.MAX_VALUE;
            feeding.feed(portion, 0, count);
            fed = next;
        }
        byte[] levels = batch == index.size() - 1 ? UNKNOWN : feeding.ofMesh();
        Resolution resolution = new Resolution(decoder.mesh(), levels);
        keep(batch, resolution);
        return resolution;
    }

    private void keep(int batch, Resolution resolution) {
        kept.put(batch, resolution);
        keptFaces += resolution.mesh().faces();
        var oldest = kept.entrySet().iterator();
        while (keptFaces > MOST_FACES && kept.size() > 1) {
            keptFaces -= oldest.next().getValue().mesh().faces();
            oldest.remove();
        }
    }
}
