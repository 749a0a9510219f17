package org.jsmesh.archive;

import java.util.List;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.UpAxis;

/**
 * What an archive says of itself: totals, attribute channels, materials, textures, bounds, levels, identity and index.
 * The first bytes of the file have only the {@link ArchiveOpening}; the rest is a batch of its own.
 *
 * @param faces of the original
 * @param vertices of the original that faces refer to
 * @param wedges distinct attribute tuples of vertices
 * @param channels the attribute channels, without values
 * @param materials the materials that faces refer to
 * @param images in the archive, each once
 * @param faceChannels the attributes of faces, without values
 * @param origin what positions and bounds count from: zeros but in double precision
 * @param bounds smallest x, y, z, then largest x, y, z
 * @param up the axis that points up
 * @param isClosed whether the original bounds a solid, so that nobody outside sees a face from behind
 * @param levels the levels of simplification, coarsest first
 * @param meshSha256 identity of the original's mesh as lower-case hexadecimal
 * @param provenance the file that the mesh came from, and what of it was lost
 * @param batches the index
 */
public record ArchiveHeader(
        int faces,
        int vertices,
        int wedges,
        List<ChannelInfo> channels,
        List<Material> materials,
        List<ImageInfo> images,
        List<FaceChannelInfo> faceChannels,
        double[] origin,
        float[] bounds,
        UpAxis up,
        boolean isClosed,
        List<Level> levels,
        String meshSha256,
        Provenance provenance,
        BatchIndex batches) {
    /**
     * Computes the identity of the original: of its mesh and its images.
     *
     * @return a SHA-256 as lower-case hexadecimal, see {@code docs/format.md}
     */
    public String modelSha256() {
        return ModelIdentity.sha256(meshSha256, images);
    }

    /**
     * A level of simplification.
     *
     * @param threshold the cost up to which collapses belonged to it
     * @param faces of the mesh when the level's last batch is applied
     * @param errorMean mean distance to the original then, in % of the diagonal
     */
    public record Level(double threshold, int faces, double errorMean) {}
}
