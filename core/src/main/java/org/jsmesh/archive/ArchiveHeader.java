package org.jsmesh.archive;

import java.util.List;
import org.jsmesh.mesh.Material;

/**
 * What an archive says of itself: totals, attribute channels, materials, textures, bounds, levels, identity and index.
 * The first bytes of the file have only the {@link ArchiveOpening}; the rest is a batch of its own.
 *
 * @param faces of the original
 * @param vertices of the original that faces refer to
 * @param wedges distinct attribute tuples of vertices
 * @param channels the attribute channels, without values
 * @param materials the materials that faces refer to
 * @param textures images in the archive
 * @param bounds smallest x, y, z, then largest x, y, z
 * @param levels the levels of simplification, coarsest first
 * @param meshSha256 identity of the original as lower-case hexadecimal
 * @param batches the index
 */
public record ArchiveHeader(
        int faces,
        int vertices,
        int wedges,
        List<ChannelInfo> channels,
        List<Material> materials,
        List<TextureInfo> textures,
        float[] bounds,
        List<Level> levels,
        String meshSha256,
        BatchIndex batches) {
    /**
     * A level of simplification.
     *
     * @param threshold the cost up to which collapses belonged to it
     * @param faces of the mesh when the level's last batch is applied
     * @param errorMean mean distance to the original then, in % of the diagonal
     */
    public record Level(double threshold, int faces, double errorMean) {}
}
