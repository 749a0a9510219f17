package org.jsmesh.encode;

import org.jsmesh.codec.PreviewCoder;
import org.jsmesh.mesh.Picture;

/** Colours of a stage of a preview, where any face shows it. */
final class PreviewRaster {
    /** Nobody sees the colour of what is less opaque. */
    private static final int UNSEEN = 16;

    private final int width;
    private final int height;
    private final int[] argb;
    private final boolean[] free;

    private PreviewRaster(int width, int height) {
        this.width = width;
        this.height = height;
        argb = new int[width * height];
        free = new boolean[width * height];
    }

    /** Means of the covered pixels. With opacity, what nobody sees gets the mean of what is seen. */
    static PreviewRaster of(Picture picture, boolean[] covered, int width, int height, boolean alpha) {
        PreviewRaster raster = new PreviewRaster(width, height);
        long[] sums = new long[5 * width * height]; // alpha, red, green, blue, weight of these
        int[] counts = new int[width * height];
        long[] all = new long[4];
        for (int i = 0; i < covered.length; i++) {
            if (!covered[i]) continue;
            int x = (int) ((long) (i % picture.width()) * width / picture.width());
            int y = (int) ((long) (i / picture.width()) * height / picture.height());
            int cell = y * width + x;
            int pixel = picture.argb()[i];
            int weight = alpha ? pixel >>> 24 : 1;
            counts[cell]++;
            sums[5 * cell] += pixel >>> 24;
            sums[5 * cell + 4] += weight;
            for (int k = 1; k < 4; k++) {
                long part = (long) weight * (pixel >> 24 - 8 * k & 255);
                sums[5 * cell + k] += part;
                all[k] += part;
            }
            all[0] += weight;
        }
        for (int c = 0; c < counts.length; c++) {
            raster.free[c] = counts[c] == 0;
            if (counts[c] == 0) continue;
            int opacity = mean(sums[5 * c], counts[c]);
            boolean isSeen = !alpha || opacity >= UNSEEN;
            for (int k = 1; k < 4; k++)
                raster.argb[c] = raster.argb[c] << 8
                        | (isSeen ? mean(sums[5 * c + k], sums[5 * c + 4]) : mean(all[k], Math.max(1, all[0])));
            raster.argb[c] |= opacity << 24;
        }
        return raster;
    }

    /** Sharpens, because viewers draw a preview smoothly: the means over its pixels are then those of the picture. */
    PreviewRaster sharp() {
        PreviewRaster sharp = new PreviewRaster(width, height);
        for (int c = 0; c < argb.length; c++) {
            sharp.free[c] = free[c];
            if (free[c]) continue;
            int x = c % width;
            int y = c / width;
            for (int shift = 0; shift < 32; shift += 8) {
                int own = argb[c] >>> shift & 255;
                int sum = 0;
                for (int k = 0; k < 9; k++) {
                    int column = x + k % 3 - 1;
                    int row = y + k / 3 - 1;
                    int at = row * width + column;
                    boolean isThere = column >= 0 && column < width && row >= 0 && row < height && !free[at];
                    sum += (k % 3 == 1 ? 6 : 1) * (k / 3 == 1 ? 6 : 1) * (isThere ? argb[at] >>> shift & 255 : own);
                }
                int level = 2 * own - (sum + 32 >> 6);
                sharp.argb[c] |= Math.max(0, Math.min(255, level)) << shift;
            }
        }
        return sharp;
    }

    private static int mean(long sum, long count) {
        return (int) ((sum + count / 2) / count);
    }

    /** The stage before: means of those of four pixels that are not free. */
    PreviewRaster half() {
        PreviewRaster half = new PreviewRaster(width / 2, height / 2);
        for (int c = 0; c < half.argb.length; c++) {
            int count = 0;
            int[] sums = new int[4];
            for (int k = 0; k < 4; k++) {
                int at = (2 * (c / half.width) + k / 2) * width + 2 * (c % half.width) + k % 2;
                if (free[at]) continue;
                count++;
                for (int p = 0; p < 4; p++) sums[p] += argb[at] >>> 24 - 8 * p & 255;
            }
            half.free[c] = count == 0;
            for (int p = 0; p < 4 && count > 0; p++) half.argb[c] = half.argb[c] << 8 | mean(sums[p], count);
        }
        return half;
    }

    PreviewCoder.Wanted wanted(int step, boolean alpha) {
        return new PreviewCoder.Wanted(width, height, step, alpha, argb, free);
    }
}
