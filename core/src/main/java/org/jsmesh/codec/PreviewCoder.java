package org.jsmesh.codec;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes a small picture of an image in stages, each with twice the width and height of the one before. A stage is coded
 * as differences from the bilinear enlargement of the stage before, the first stage as differences from the neighbours
 * (the median predictor of LOCO-I, Weinberger, Seroussi, Sapiro 2000). Colours are luma and two differences (YCoCg-R,
 * Malvar and Sullivan 2003), in steps.
 */
public final class PreviewCoder {
    /** A picture has at most so many columns and rows. */
    public static final int LARGEST = 256;

    private static final int[] STEPS = {8, 12, 12};
    private static final int SIDE_BITS = 4; // of the first stage
    private static final int ACTIVITIES = 3;
    private final IntegerModel residuals = new IntegerModel(4 * ACTIVITIES);
    private int width;
    private int height;
    private int[][] planes; // luma, orange − blue, green − magenta; null before the first stage
    private int[][] before;
    private int[][] steps; // residuals of the stage, in steps

    /** Width of the last stage coded, 0 before the first. */
    public int width() {
        return width;
    }

    /** Height of the last stage coded. */
    public int height() {
        return height;
    }

    /**
     * Codes the next stage.
     *
     * @param firstWidth width of the first stage, 1 to 16; ignored later and by a decoder
     * @param rgb per pixel of the stage, −1 where any colour will do; null for a decoder
     * @throws MalformedStreamException when the picture becomes too large
     */
    public void codeStage(BinaryCoder coder, int firstWidth, int firstHeight, int[] rgb)
            throws MalformedStreamException {
        before = planes;
        if (before == null) {
            width = 1 + coder.raw(firstWidth - 1, SIDE_BITS);
            height = 1 + coder.raw(firstHeight - 1, SIDE_BITS);
        } else {
            if (2 * Math.max(width, height) > LARGEST)
                throw new MalformedStreamException(-1, "a preview of more than " + LARGEST + " pixels");
            width *= 2;
            height *= 2;
        }
        planes = new int[3][width * height];
        steps = new int[3][width * height];
        int[] wanted = new int[3];
        for (int i = 0; i < width * height; i++) {
            boolean isGiven = rgb != null && rgb[i] >= 0;
            if (isGiven) split(rgb[i], wanted);
            for (int plane = 0; plane < 3; plane++) codeValue(coder, plane, i, isGiven, wanted[plane]);
        }
    }

    private void codeValue(BinaryCoder coder, int plane, int i, boolean isGiven, int wanted) {
        int predicted = before == null ? fromNeighbours(plane, i) : enlarged(before[plane], i);
        int step = STEPS[plane];
        int left = isGiven ? Math.floorDiv(2 * (wanted - predicted) + step, 2 * step) : 0;
        int activity = 0;
        if (i % width > 0) activity += Math.abs(steps[plane][i - 1]);
        if (i >= width) activity += Math.abs(steps[plane][i - width]);
        boolean lumaDiffers = plane > 0 && steps[0][i] != 0;
        int statistics = ((plane > 0 ? 2 : 0) + (lumaDiffers ? 1 : 0)) * ACTIVITIES + Math.min(activity, 2);
        // Beyond 255 only in damaged streams.
        int coded = Math.max(-255, Math.min(255, residuals.signed(coder, statistics, left)));
        steps[plane][i] = coded;
        int value = predicted + coded * step;
        planes[plane][i] = Math.max(plane == 0 ? 0 : -255, Math.min(255, value));
    }

    private int fromNeighbours(int plane, int i) {
        int[] values = planes[plane];
        boolean hasLeft = i % width > 0;
        if (i < width) return hasLeft ? values[i - 1] : plane == 0 ? 128 : 0;
        int above = values[i - width];
        if (!hasLeft) return above;
        int left = values[i - 1];
        int corner = values[i - width - 1];
        int low = Math.min(left, above);
        int high = Math.max(left, above);
        return corner >= high ? low : corner <= low ? high : left + above - corner;
    }

    /**
     * A value of the stage before, enlarged: each pixel lies a quarter of an old pixel away from the middle of the old
     * pixel that it is in.
     */
    private int enlarged(int[] values, int i) {
        int x = i % width;
        int y = i / width;
        int oldWidth = width / 2;
        int oldHeight = height / 2;
        int x0 = x / 2;
        int y0 = y / 2;
        int x1 = Math.max(0, Math.min(oldWidth - 1, x0 + 2 * (x & 1) - 1));
        int y1 = Math.max(0, Math.min(oldHeight - 1, y0 + 2 * (y & 1) - 1));
        int near = 9 * values[y0 * oldWidth + x0] + 3 * values[y0 * oldWidth + x1];
        int far = 3 * values[y1 * oldWidth + x0] + values[y1 * oldWidth + x1];
        return near + far + 8 >> 4;
    }

    private static void split(int rgb, int[] planes) {
        int red = rgb >> 16 & 255;
        int green = rgb >> 8 & 255;
        int blue = rgb & 255;
        planes[1] = red - blue;
        int middle = blue + (planes[1] >> 1);
        planes[2] = green - middle;
        planes[0] = middle + (planes[2] >> 1);
    }

    /** The colours of the last stage coded: red × 65536 + green × 256 + blue per pixel, row by row from the top. */
    public int[] rgb() {
        int[] rgb = new int[width * height];
        for (int i = 0; i < rgb.length; i++) {
            int middle = planes[0][i] - (planes[2][i] >> 1);
            int green = planes[2][i] + middle;
            int blue = middle - (planes[1][i] >> 1);
            int red = blue + planes[1][i];
            rgb[i] = level(red) << 16 | level(green) << 8 | level(blue);
        }
        return rgb;
    }

    private static int level(int value) {
        return Math.max(0, Math.min(255, value));
    }
}
