package org.jsmesh.archive;

import java.util.List;
import org.jsmesh.mesh.Material;

/**
 * What the first bytes of an archive say: what it takes to decode and show the first batches. Totals, identity, levels
 * and the rest of the index come a few batches later, with the {@link ArchiveHeader}.
 *
 * @param channels the attribute channels, without values
 * @param materials the materials that faces refer to
 * @param textures images in the archive
 * @param box around the mesh, somewhat larger than its bounds: smallest x, y, z, then largest x, y, z
 * @param batches the first rows of the index, up to the batch that has the rest of the header
 */
public record ArchiveOpening(
        List<ChannelInfo> channels,
        List<Material> materials,
        List<TextureInfo> textures,
        float[] box,
        BatchIndex batches) {}
