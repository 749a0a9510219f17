package org.jsmesh.archive;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.UpAxis;

/**
 * What the first bytes of an archive say: what it takes to decode and show the first batches. Totals, identity, levels
 * and the rest of the index come a few batches later, with the {@link ArchiveHeader}.
 *
 * @param channels the attribute channels, without values
 * @param materials the materials that faces refer to
 * @param images in the archive, each once
 * @param origin what positions and the box count from: zeros but in double precision
 * @param box around the mesh, somewhat larger than its bounds: smallest x, y, z, then largest x, y, z
 * @param up the axis that points up
 * @param isClosed whether the original bounds a solid, so that nobody outside sees a face from behind
 * @param batches the first rows of the index, up to the batch that has the rest of the header
 */
public record ArchiveOpening(
        List<ChannelInfo> channels,
        List<Material> materials,
        List<ImageInfo> images,
        double[] origin,
        float[] box,
        UpAxis up,
        boolean isClosed,
        BatchIndex batches) {}
