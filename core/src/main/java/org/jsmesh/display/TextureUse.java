package org.jsmesh.display;

import java.util.List;

/**
 * How a material uses an image. With (u, v) the vertex' texture coordinates of the set, and (a, b, c, d, e, f) the
 * transform, the place on the image is (a·u + b·v + c, d·u + e·v + f): in widths from the left edge and in heights from
 * the upper one.
 *
 * @param path of the image, as textures have it
 * @param set of texture coordinates, from 0
 * @param sampler what to do between pixels and outside the image
 * @param transform six numbers
 * @param factor scale of normals and bumps, strength of occlusion; 1 for other slots
 * @param channel of the image that counts, 0 red to 3 alpha; −1 for all
 */
public record TextureUse(String path, int set, Sampler sampler, List<Float> transform, float factor, int channel) {
    /** The transform that leaves coordinates as they are. */
    static final List<Float> IDENTITY = List.of(1f, 0f, 0f, 0f, 1f, 0f);

    /**
     * Filters and wrapping, as the numbers that OpenGL and glTF have for them.
     *
     * @param magFilter 9728 nearest, 9729 linear
     * @param minFilter 9728, 9729, or 9984 to 9987 for those with smaller images
     * @param wrapU 10497 repeat, 33071 clamp to edge, 33648 mirrored repeat
     * @param wrapV likewise
     */
    public record Sampler(int magFilter, int minFilter, int wrapU, int wrapV) {
        /** Linear, between smaller images too, and repeated. */
        static final Sampler USUAL = new Sampler(9729, 9987, 10497, 10497);

        /** Linear, between smaller images too, with the colour of the edge outside. */
        static final Sampler CLAMPED = new Sampler(9729, 9987, 33071, 33071);

        /** {@return whether the colour of the edge goes on outside the image, both ways} */
        public boolean isClamped() {
            return equals(CLAMPED);
        }
    }
}
