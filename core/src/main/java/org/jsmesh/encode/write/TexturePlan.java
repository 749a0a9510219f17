package org.jsmesh.encode.write;

import java.util.List;

/**
 * What the image of a texture, and small previews of it, gain for the picture: by how much each brings the colours of
 * the surface closer to the original's, in % of white, averaged over its area.
 *
 * @param stages of the preview, to be sent in this order before the image; none after it
 * @param gain of the image when all stages are there; 0 when viewers do not show it
 */
public record TexturePlan(List<Stage> stages, double gain) {
    public TexturePlan {
        stages = List.copyOf(stages);
    }

    /**
     * A stage of a preview.
     *
     * @param width in pixels, used for the first stage alone
     * @param height likewise
     * @param rgb as {@link org.jsmesh.codec.PreviewCoder#codeStage} takes it
     * @param gain over the stage before
     */
    public record Stage(int width, int height, int[] rgb, double gain) {}

    /** An image without a preview. */
    public static TexturePlan imageAlone(double gain) {
        return new TexturePlan(List.of(), gain);
    }
}
