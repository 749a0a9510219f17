package org.jsmesh.encode.write;

import java.util.List;
import org.jsmesh.codec.PreviewCoder;

/**
 * What the image of a texture, and small previews of it, gain for the picture: by how much each brings the colours of
 * the surface closer to the original's, in % of white, averaged over its area.
 *
 * @param steps of the preview, to be sent in this order before the image; none after it
 * @param gain of the image when all steps are there; 0 when viewers do not show it
 * @param isShape whether the image changes how the surface takes the light. Its preview then comes before any image
 */
public record TexturePlan(List<Step> steps, double gain, boolean isShape) {
    public TexturePlan {
        steps = List.copyOf(steps);
    }

    /**
     * Stages of a preview that are worth their bytes only together.
     *
     * @param stages the next ones
     * @param bytes of them, about
     * @param gain over the step before
     */
    public record Step(List<PreviewCoder.Wanted> stages, int bytes, double gain) {}

    /** Pixels of the longer side of the last stage, or 0. */
    public int previewSide() {
        int side = 0;
        for (Step step : steps)
            for (PreviewCoder.Wanted stage : step.stages())
                side = Math.max(side, Math.max(stage.width(), stage.height()));
        return side;
    }

    /** An image without a preview. */
    public static TexturePlan imageAlone(double gain) {
        return new TexturePlan(List.of(), gain, false);
    }
}
