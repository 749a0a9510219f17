package org.jsmesh.archive;

import org.jsmesh.mesh.Channel;

/**
 * An attribute channel of an archive: a {@link Channel} without its values.
 *
 * @param semantic what the values are
 * @param name of the channel
 * @param components numbers per value
 * @param type of the numbers
 */
public record ChannelInfo(Channel.Semantic semantic, String name, int components, Channel.Type type) {}
