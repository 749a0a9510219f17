package org.jsmesh.codec.attribute;

import org.jsmesh.codec.connectivity.EncoderTruth;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes exact attribute values of all wedges in order, when all splits are there: first those of 8-bit channels, at any
 * precision of the positions, and in a second sweep all others, predicted from the exact mesh.
 */
public final class AttributeSweep {
    private final ChannelValues[] values;
    private final ChannelRefiner[] refiners; // null for channels that this sweep does not make exact
    private final EncoderTruth truth;
    private final LodMesh mesh;
    private final int[] order;
    private int done;

    public AttributeSweep(
            LodMesh mesh,
            Translation translation,
            WedgeTwins twins,
            ChannelValues[] values,
            ChannelRefiner[] refiners,
            EncoderTruth truth) {
        this.mesh = mesh;
        this.values = values;
        this.refiners = refiners;
        this.truth = truth;
        boolean hasNormals = false;
        for (ChannelValues v : values) hasNormals |= v.format.normals() != null;
        order = WedgeOrder.of(mesh, hasNormals);
        WedgeRing ring = new WedgeRing(mesh, translation);
        for (ChannelRefiner refiner : refiners) if (refiner != null) refiner.begin(mesh, translation, ring, twins);
    }

    public int left() {
        return order.length - done;
    }

    public void code(BinaryCoder stream, int count) throws MalformedStreamException {
        if (count > left()) throw new MalformedStreamException(-1, "attributes of more wedges than there are");
        for (int i = 0; i < count; i++, done++) {
            if ((i & 15) == 0 && stream.isExhausted()) return;
            int wedge = order[done];
            if (mesh.changes() != null) mesh.changes().changeWedge(wedge);
            for (int c = 0; c < values.length; c++) {
                if (refiners[c] == null) continue;
                if (!values[c].absent.get(wedge))
                    refiners[c].code(stream, wedge, truth == null ? -1 : truth.originalWedge(wedge));
                values[c].refined.set(wedge);
            }
        }
    }
}
