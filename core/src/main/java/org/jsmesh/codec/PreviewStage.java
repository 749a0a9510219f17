package org.jsmesh.codec;

import org.jsmesh.codec.entropy.BinaryCoder;

/**
 * A stage of a preview: planes of luma, of two differences of colours and, where there is any, of opacity. The values
 * of a first stage are coded as differences from their neighbours (the median predictor of LOCO-I, Weinberger,
 * Seroussi, Sapiro 2000). A later stage splits each pixel of the stage before into four with the same mean, by three
 * details. Those across and down are expected to follow the slope of the stage before: this is the average
 * interpolation of Donoho 1993, of second order.
 */
final class PreviewStage {
    static final int ALPHA = 3;
    private static final int OPAQUE = 255;
    private static final int ALL = 15; // pixels of the four, as bits
    private static final int MOST = 255;
    private static final int MOST_KEPT = 127;

    final int width;
    final int height;
    final int planeCount;
    private final boolean isFirst;
    private final int lumaStep;
    private final short[][] planes;
    private final byte[][]
            coded; // in steps; of a later stage detail after detail, pixel after pixel of the stage before
    private final PreviewModel model;
    private final PreviewModel.Around around = new PreviewModel.Around();
    private final int[] details = new int[PreviewModel.DETAILS];

    PreviewStage(PreviewModel model, boolean isFirst, int width, int height, int planeCount, int lumaStep) {
        this.model = model;
        this.isFirst = isFirst;
        this.width = width;
        this.height = height;
        this.planeCount = planeCount;
        this.lumaStep = lumaStep;
        planes = new short[planeCount][width * height];
        coded = new byte[planeCount][width * height];
    }

    private int step(int plane) {
        return plane == 0 || plane == ALPHA ? lumaStep : 3 * lumaStep + 1 >> 1;
    }

    /** Codes a row of a first stage. */
    void codeRow(BinaryCoder coder, int y, PreviewCoder.Wanted wanted) {
        int[] values = new int[planeCount];
        for (int x = 0; x < width; x++) {
            boolean isGiven = wanted != null && !wanted.free()[y * width + x];
            if (isGiven) split(wanted.argb()[y * width + x], values);
            for (int plane = 0; plane < planeCount; plane++) codeFirst(coder, plane, x, y, isGiven, values[plane]);
        }
    }

    private void codeFirst(BinaryCoder coder, int plane, int x, int y, boolean isGiven, int wanted) {
        byte[] values = coded[plane];
        int at = y * width + x;
        around.clear();
        around.neighbours = 2 * ((x > 0 ? Math.abs(values[at - 1]) : 0) + (y > 0 ? Math.abs(values[at - width]) : 0));
        if (plane > 0) around.luma = coded[0][at];
        int predicted = fromNeighbours(plane, x, y);
        int step = step(plane);
        int steps = isGiven ? Math.floorDiv(2 * (wanted - predicted) + step, 2 * step) : 0;
        steps = code(coder, plane, PreviewModel.DETAILS, steps);
        values[at] = kept(steps);
        planes[plane][at] = limited(plane, predicted + steps * step);
    }

    private int fromNeighbours(int plane, int x, int y) {
        short[] values = planes[plane];
        int at = y * width + x;
        if (y == 0) return x > 0 ? values[at - 1] : plane == 0 ? 128 : plane == ALPHA ? OPAQUE : 0;
        int above = values[at - width];
        if (x == 0) return above;
        int left = values[at - 1];
        int corner = values[at - width - 1];
        int low = Math.min(left, above);
        int high = Math.max(left, above);
        return corner >= high ? low : corner <= low ? high : left + above - corner;
    }

    /** Codes the two rows of a later stage that a row of the stage before is split into. */
    void codeRows(BinaryCoder coder, int y, PreviewStage before, PreviewCoder.Wanted wanted) {
        int[][] four = new int[planeCount][4];
        int[] values = new int[planeCount];
        for (int x = 0; x < before.width; x++) {
            int free = 0;
            for (int k = 0; k < 4 && wanted != null; k++) {
                int at = pixel(x, y, k);
                if (wanted.free()[at]) {
                    free |= 1 << k;
                    continue;
                }
                split(wanted.argb()[at], values);
                for (int plane = 0; plane < planeCount; plane++) four[plane][k] = values[plane];
            }
            for (int plane = 0; plane < planeCount; plane++)
                codeFour(coder, plane, x, y, before, wanted == null ? null : four[plane], free);
        }
    }

    /** Pixel k of the four, row by row, of a pixel of the stage before. */
    private int pixel(int x, int y, int k) {
        return (2 * y + (k >> 1)) * width + 2 * x + (k & 1);
    }

    private void codeFour(BinaryCoder coder, int plane, int x, int y, PreviewStage before, int[] wanted, int free) {
        short[] old = before.planes[plane];
        int w = before.width;
        int at = y * w + x;
        int middle = old[at];
        int left = x > 0 ? old[at - 1] : middle;
        int right = x < w - 1 ? old[at + 1] : middle;
        int above = y > 0 ? old[at - w] : middle;
        int below = y < before.height - 1 ? old[at + w] : middle;
        int low = Math.min(middle, Math.min(Math.min(left, right), Math.min(above, below)));
        int high = Math.max(middle, Math.max(Math.max(left, right), Math.max(above, below)));
        int step = step(plane);
        details[0] = right - left + 4 >> 3;
        details[1] = below - above + 4 >> 3;
        details[2] = 0;
        around.clear();
        around.rough = 4 * (high - low) / step;
        for (int detail = 0; detail < PreviewModel.DETAILS; detail++) {
            int i = detail * w * before.height + at;
            look(plane, detail, x, y, i, before);
            int steps = wanted == null ? 0 : stepsTo(wanted, free, middle, detail, step);
            steps = code(coder, plane, detail, steps);
            coded[plane][i] = kept(steps);
            around.before += Math.abs(kept(steps));
            details[detail] += steps * step;
        }
        for (int k = 0; k < 4; k++) planes[plane][pixel(x, y, k)] = limited(plane, value(middle, k));
    }

    /** Looks at what is known around a detail. */
    private void look(int plane, int detail, int x, int y, int i, PreviewStage before) {
        byte[] values = coded[plane];
        int w = before.width;
        int left = x > 0 ? values[i - 1] : 0;
        int above = y > 0 ? values[i - w] : 0;
        int corners = (x > 0 && y > 0 ? Math.abs(values[i - w - 1]) : 0)
                + (x < w - 1 && y > 0 ? Math.abs(values[i - w + 1]) : 0);
        around.neighbours = 2 * (Math.abs(left) + Math.abs(above)) + corners;
        around.sign = Integer.signum(detail == 0 ? above : left);
        around.luma = plane == 0 ? 0 : coded[0][i];
        int there = before.isFirst ? y * w + x : (detail * (before.height >> 1) + (y >> 1)) * (w >> 1) + (x >> 1);
        around.coarser = Math.abs(before.coded[plane][there]);
    }

    private int stepsTo(int[] wanted, int free, int middle, int detail, int step) {
        int rest = 4 * middle;
        int sum = 0;
        for (int k = 0; k < 4; k++) {
            if ((free >> k & 1) != 0) continue;
            rest -= wanted[k];
            sum += sign(detail, k) * wanted[k];
        }
        if (free == ALL) return 0;
        // The mean of the four stays, so free pixels take what the others leave.
        for (int k = 0; k < 4 && free != 0; k++)
            if ((free >> k & 1) != 0) sum += sign(detail, k) * rest / Integer.bitCount(free);
        double off = sum / 4.0 - details[detail];
        int steps = (int) (Math.abs(off) / step + .5);
        return off < 0 ? -steps : steps;
    }

    /** A pixel of the four by the details as they are known. */
    private int value(int middle, int k) {
        return middle + sign(0, k) * details[0] + sign(1, k) * details[1] + sign(2, k) * details[2];
    }

    /** Sign of a detail (across, down, both) in pixel k of the four. */
    private static int sign(int detail, int k) {
        int x = (k & 1) == 0 ? -1 : 1;
        int y = k < 2 ? -1 : 1;
        return detail == 0 ? x : detail == 1 ? y : x * y;
    }

    /** Beyond 255 steps only in damaged streams. */
    private int code(BinaryCoder coder, int plane, int kind, int steps) {
        return Math.max(-MOST, Math.min(MOST, model.code(coder, plane, kind, around, steps)));
    }

    private static byte kept(int steps) {
        return (byte) Math.max(-MOST_KEPT, Math.min(MOST_KEPT, steps));
    }

    private static short limited(int plane, int value) {
        return (short) Math.max(plane == 0 || plane == ALPHA ? 0 : -MOST, Math.min(MOST, value));
    }

    private static void split(int argb, int[] planes) {
        int red = argb >> 16 & 255;
        int green = argb >> 8 & 255;
        int blue = argb & 255;
        planes[1] = red - blue;
        int middle = blue + (planes[1] >> 1);
        planes[2] = green - middle;
        planes[0] = middle + (planes[2] >> 1);
        if (planes.length > ALPHA) planes[ALPHA] = argb >>> 24;
    }

    /** Alpha, red, green, blue from the highest byte on, row by row from the top. */
    int[] argb() {
        int[] argb = new int[width * height];
        for (int i = 0; i < argb.length; i++) {
            int middle = planes[0][i] - (planes[2][i] >> 1);
            int green = planes[2][i] + middle;
            int blue = middle - (planes[1][i] >> 1);
            int red = blue + planes[1][i];
            int alpha = planeCount > ALPHA ? planes[ALPHA][i] : OPAQUE;
            argb[i] = alpha << 24 | level(red) << 16 | level(green) << 8 | level(blue);
        }
        return argb;
    }

    private static int level(int value) {
        return Math.max(0, Math.min(255, value));
    }
}
