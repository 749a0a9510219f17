package org.jsmesh.archive;

import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.FaceChannel;

/**
 * An attribute of the faces of an archive: a {@link FaceChannel} without its values and labels.
 *
 * @param name of the channel
 * @param components numbers per value
 * @param type of the numbers
 */
public record FaceChannelInfo(String name, int components, Channel.Type type) {}
