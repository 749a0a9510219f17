package org.jsmesh.codec;

import org.jsmesh.mesh.Channel;

/**
 * How a channel is coded.
 *
 * @param lattice of its values; null for 8-bit integers
 * @param hasAbsent whether wedges may lack it
 */
record ChannelFormat(
        Channel.Semantic semantic,
        String name,
        int components,
        Channel.Type type,
        Lattice lattice,
        boolean hasAbsent) {}
