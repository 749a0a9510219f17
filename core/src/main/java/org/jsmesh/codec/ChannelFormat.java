package org.jsmesh.codec;

import org.jsmesh.mesh.Channel;

/**
 * How a channel is coded.
 *
 * @param lattice of its values; null for 8-bit integers
 * @param hasAbsent whether wedges may lack it
 * @param shift values come with their wedge in units of 2^shift cells, and exactly in the last sweep; 0: exactly at once
 * @param normals what the values are predicted by, in the last sweep alone; null when they are not normals
 */
record ChannelFormat(
        Channel.Semantic semantic,
        String name,
        int components,
        Channel.Type type,
        Lattice lattice,
        boolean hasAbsent,
        int shift,
        NormalFormula normals) {

    /** Does the last sweep bring values? */
    boolean isRefined() {
        return shift > 0 || normals != null;
    }
}
