package org.jsmesh.codec;

import org.jsmesh.mesh.MalformedStreamException;

/** Codes the exact values of a channel, wedge after wedge, when everything else is exact. */
interface ChannelRefiner {
    /**
     * @param ring measures the surroundings of wedges
     * @param twins mirror images of wedges; null where there is no mirror
     */
    void begin(LodMesh mesh, Translation translation, WedgeRing ring, WedgeTwins twins);

    /** Codes the exact values of a wedge that has the attribute. */
    void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException;
}
