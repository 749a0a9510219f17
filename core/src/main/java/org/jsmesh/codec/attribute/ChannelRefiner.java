package org.jsmesh.codec.attribute;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the exact values of a channel, wedge after wedge, in an {@link AttributeSweep}. Faces are exact then; positions
 * are exact too, except for 8-bit channels.
 */
public interface ChannelRefiner {
    /**
     * @param ring measures the surroundings of wedges
     * @param twins mirror images of wedges; null where there is no mirror
     */
    void begin(LodMesh mesh, Translation translation, WedgeRing ring, WedgeTwins twins);

    /** Codes the exact values of a wedge that has the attribute. */
    void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException;
}
