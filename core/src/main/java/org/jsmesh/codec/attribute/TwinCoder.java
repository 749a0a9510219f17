package org.jsmesh.codec.attribute;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.Channel;

/**
 * Codes whether a wedge has the very same values of a channel as a wedge that is exact already and has the same units:
 * its mirror image, or else the last such wedge.
 */
final class TwinCoder {
    private final ChannelValues values;
    private final Channel original; // encoder only
    private final int[] same = BinaryCoder.newContexts(2);
    private int lastSame;
    private WedgeTwins images; // null where there is no mirror
    private TwinTable twins;

    TwinCoder(ChannelValues values, Channel original) {
        this.values = values;
        this.original = original;
    }

    void begin(LodMesh mesh, WedgeTwins mirrored) {
        images = mirrored;
        twins = new TwinTable(values, mesh.wedges());
    }

    /**
     * Takes the values of the wedge in the same units, if there is one and they are the same. Returns false when they
     * must be coded.
     */
    boolean code(BinaryCoder coder, int wedge, int originalWedge) {
        int twin = twin(wedge);
        if (twin < 0) return false;
        int is = 1;
        for (int k = 0; k < values.components && coder.isEncoder(); k++)
            if (original.values()[values.components * originalWedge + k] != values.value(twin, k)) is = 0;
        lastSame = coder.bit(same, lastSame, is);
        if (lastSame == 0) return false;
        for (int k = 0; k < values.components; k++) values.set(wedge, k, values.cell(twin, k), values.value(twin, k));
        return true;
    }

    private int twin(int wedge) {
        int last = twins.replace(wedge);
        int image = images == null ? -1 : images.of(wedge);
        boolean isLikely =
                image >= 0 && values.refined.get(image) && !values.absent.get(image) && twins.isAlike(wedge, image);
        return isLikely ? image : last;
    }
}
