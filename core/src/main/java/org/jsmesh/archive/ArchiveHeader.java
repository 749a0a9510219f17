package org.jsmesh.archive;

import java.util.List;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Material;

/**
 * What an archive says of itself: totals, attribute channels, materials, textures, bounds, levels, identity and index.
 *
 * <p>The opening of the file, before the base mesh, has only the first part of this. The rest is a batch of its own.
 * Until it has come, the totals are those after the last batch known so far, the bounds are those of a box around the
 * mesh, there are no levels and no identity, and the index ends with the batch that has the rest: see {@link #isWhole}.
 *
 * @param faces of the original
 * @param vertices of the original that faces refer to
 * @param wedges distinct attribute tuples of vertices; the vertices until the header is whole
 * @param channels the attribute channels, without values
 * @param materials the materials that faces refer to
 * @param textures images in the archive
 * @param bounds smallest x, y, z, then largest x, y, z
 * @param levels the levels of simplification, coarsest first
 * @param meshSha256 identity of the original as lower-case hexadecimal, or null until the header is whole
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

    /** True when all of it is there. */
    public boolean isWhole() {
        return meshSha256 != null;
    }

    /** An attribute channel of {@link Channel} without its values. */
    public record ChannelInfo(Channel.Semantic semantic, String name, int components, Channel.Type type) {}

    /** An image in the archive: its path in the materials and its size. */
    public record TextureInfo(String path, int bytes) {}

    /**
     * A level of simplification.
     *
     * @param threshold the cost up to which collapses belonged to it
     * @param faces of the mesh when the level's last batch is applied
     * @param errorMean mean distance to the original then, in % of the diagonal
     */
    public record Level(double threshold, int faces, double errorMean) {}
}
