package org.jsmesh.encode;

import java.util.List;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.Slot;
import org.jsmesh.display.TextureUse;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/**
 * How a material uses an image: where the image lies on a face, and how much a change of its pixels changes the colour
 * that is seen.
 */
final class ImageUse {
    private static final int REPEAT = 10497;
    private static final int MIRRORED = 33648;
    private static final double WHITE = 255;
    private static final double FLAT = 127.5;
    /** Change of the light on a surface when its normal tilts so that its x or y changes by 1, on average. */
    private static final double BY_NORMAL = .4;

    private static final double BY_BUMP = .2;
    private static final double BY_OCCLUSION = .2;
    private static final double BY_SURFACE = .1; // metal, roughness
    private static final double BY_OPACITY = .5;

    private final PaintedImage image;
    private final int number; // among the uses of the image
    private final Slot slot;
    private final TextureUse use;
    private final Channel set;
    private final double[] factors; // of red, green, blue
    private final double[] plain; // what is seen without the image, 0 to 255
    private final boolean alphaCounts;

    ImageUse(DisplayMaterial look, Slot slot, TextureUse use, Channel set, PaintedImage image) {
        this.image = image;
        number = image.add(this);
        this.slot = slot;
        this.use = use;
        this.set = set;
        boolean mayShine = look.alpha() != DisplayMaterial.Alpha.OPAQUE;
        alphaCounts = slot == Slot.COLOUR && mayShine || slot == Slot.OPACITY;
        factors = new double[] {1, 1, 1};
        plain = new double[] {WHITE, WHITE, WHITE};
        float[] colour = look.plain();
        List<Float> light = look.emission();
        for (int k = 0; k < 3; k++) {
            if (slot == Slot.COLOUR && look.linear()) factors[k] = colour[k];
            if (slot == Slot.COLOUR) plain[k] = WHITE * colour[k];
            if (slot == Slot.EMISSION) {
                factors[k] = light == null ? 1 : Math.min(1, light.get(k));
                plain[k] = 0;
            }
            if (slot == Slot.NORMAL) plain[k] = FLAT;
        }
    }

    PaintedImage image() {
        return image;
    }

    int number() {
        return number;
    }

    boolean isShape() {
        return slot == Slot.NORMAL || slot == Slot.BUMP;
    }

    /** Whether the image's colours are seen as they are. */
    boolean isColour() {
        return slot == Slot.COLOUR || slot == Slot.EMISSION;
    }

    /** Whether the image's own opacity is seen. */
    boolean needsAlpha() {
        return alphaCounts;
    }

    /** Writes where a point of a face lies on the image, in widths and heights from its upper left corner. */
    void place(Mesh mesh, int face, double second, double third, double[] place) {
        double u = mean(mesh, face, 0, second, third);
        double v = mean(mesh, face, 1, second, third);
        List<Float> t = use.transform();
        place[0] = t.get(0) * u + t.get(1) * v + t.get(2);
        place[1] = t.get(3) * u + t.get(4) * v + t.get(5);
    }

    private double mean(Mesh mesh, int face, int component, double second, double third) {
        int[] wedges = mesh.faceWedges();
        return (1 - second - third) * set.number(wedges[3 * face], component)
                + second * set.number(wedges[3 * face + 1], component)
                + third * set.number(wedges[3 * face + 2], component);
    }

    /** The place within the image, 0 to 1, that stands for one anywhere. */
    double wrapped(double place, boolean isAcross) {
        int wrap = isAcross ? use.sampler().wrapU() : use.sampler().wrapV();
        double whole = Math.floor(place);
        if (wrap == REPEAT) return place - whole;
        if (wrap == MIRRORED) return whole % 2 == 0 ? place - whole : 1 - (place - whole);
        return Math.max(0, Math.min(1, place));
    }

    /** What the difference of two pixels changes of what is seen, 0 to 255. */
    double difference(int a, int b) {
        return weigh(
                (a >>> 24) - (b >>> 24),
                (a >> 16 & 255) - (b >> 16 & 255),
                (a >> 8 & 255) - (b >> 8 & 255),
                (a & 255) - (b & 255));
    }

    /** The same for a pixel against what is seen without the image. */
    double differenceFromPlain(int argb) {
        double[] at = {argb >> 16 & 255, argb >> 8 & 255, argb & 255};
        if (slot != Slot.COLOUR) {
            double alpha = slot == Slot.OPACITY ? (argb >>> 24) - WHITE : 0;
            return weigh(alpha, at[0] - plain[0], at[1] - plain[1], at[2] - plain[2]);
        }
        double sum = alphaCounts ? BY_OPACITY * (WHITE - (argb >>> 24)) : 0;
        for (int k = 0; k < 3; k++) sum += Math.abs(factors[k] * at[k] - plain[k]) / 3;
        return sum;
    }

    private double weigh(double alpha, double red, double green, double blue) {
        double all = (Math.abs(red) + Math.abs(green) + Math.abs(blue)) / 3;
        double one = switch (use.channel()) {
            case 0 -> Math.abs(red);
            case 1 -> Math.abs(green);
            case 2 -> Math.abs(blue);
            case 3 -> Math.abs(alpha);
            default -> all;
        };
        return switch (slot) {
            case COLOUR, EMISSION ->
                (Math.abs(factors[0] * red) + Math.abs(factors[1] * green) + Math.abs(factors[2] * blue)) / 3
                        + (alphaCounts ? BY_OPACITY * Math.abs(alpha) : 0);
            case NORMAL -> BY_NORMAL * 2 * Math.sqrt(red * red + green * green) * Math.min(1, Math.abs(use.factor()));
            case BUMP -> BY_BUMP * all;
            case OCCLUSION -> BY_OCCLUSION * one * use.factor();
            case METALLIC, ROUGHNESS -> BY_SURFACE * one;
            case OPACITY -> BY_OPACITY * Math.max(one, Math.abs(alpha));
        };
    }
}
