package org.jsmesh.encode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.mesh.Picture;

/** The points of a mesh that show an image, and the pixels that faces cover. */
final class PaintedImage {
    /** Pixels tried per pixel of the picture; beyond that all of it counts as covered. */
    private static final int MOST_TRIED = 64;

    private static final int OPAQUE = 255;
    /** Pixels from the origin that are still told from their neighbours. */
    private static final int FURTHEST = 1 << 30;

    private final Picture picture; // or null
    private final boolean[] covered;
    private long tried;
    private final List<ImageUse> uses = new ArrayList<>();
    private float[] places = new float[1024]; // two per point
    private int[] useOf = new int[512];
    private int count;
    private int shown; // points, of one use
    private int colourPoints;

    PaintedImage(Picture picture) {
        this.picture = picture;
        covered = picture == null ? null : new boolean[picture.width() * picture.height()];
    }

    /** Takes a use and gives the number that it has here. */
    int add(ImageUse use) {
        uses.add(use);
        return uses.size() - 1;
    }

    boolean isRead() {
        return picture != null;
    }

    boolean isShape() {
        return uses.stream().anyMatch(ImageUse::isShape);
    }

    void add(ImageUse use, double x, double y) {
        if (use.number() == 0) shown++;
        if (use.isColour()) colourPoints++;
        if (picture == null || Double.isNaN(x) || Double.isNaN(y)) return;
        if (count == useOf.length) {
            places = Arrays.copyOf(places, 4 * count);
            useOf = Arrays.copyOf(useOf, 2 * count);
        }
        places[2 * count] = (float) x;
        places[2 * count + 1] = (float) y;
        useOf[count++] = use.number();
    }

    /** Pixels of the picture in a row. */
    int width() {
        return picture.width();
    }

    int height() {
        return picture.height();
    }

    /** Share of the surface, for the use that there was first. */
    double share() {
        return (double) shown / PaintedPoints.POINTS;
    }

    /** Points whose own colour, or light, is the image's. */
    int colourPoints() {
        return colourPoints;
    }

    /** Marks the pixels of a face, and those beside them, which filters mix in. */
    void cover(double[] corners, ImageUse use) {
        if (picture == null || tried < 0) return;
        int w = picture.width();
        int h = picture.height();
        double[] c = new double[6];
        for (int k = 0; k < 6; k++) c[k] = corners[k] * (k % 2 == 0 ? w : h);
        double left = Math.min(c[0], Math.min(c[2], c[4])) - 1;
        double right = Math.max(c[0], Math.max(c[2], c[4])) + 1;
        double top = Math.min(c[1], Math.min(c[3], c[5])) - 1;
        double bottom = Math.max(c[1], Math.max(c[3], c[5])) + 1;
        double size = (right - left + 1) * (bottom - top + 1);
        double furthest = Math.max(Math.max(-left, right), Math.max(-top, bottom));
        if (!(size <= (double) MOST_TRIED * w * h - tried) || furthest > FURTHEST) {
            Arrays.fill(covered, true);
            tried = -1;
            return;
        }
        tried += (long) size;
        double turn = (c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1]) < 0 ? -1 : 1;
        for (int y = (int) Math.floor(top); y <= bottom; y++)
            for (int x = (int) Math.floor(left); x <= right; x++)
                if (isNear(c, turn, x + .5, y + .5)) {
                    int column = pixel(use.wrapped((x + .5) / w, true), w);
                    covered[pixel(use.wrapped((y + .5) / h, false), h) * w + column] = true;
                }
    }

    private static boolean isNear(double[] c, double turn, double x, double y) {
        for (int k = 0; k < 6; k += 2) {
            int next = (k + 2) % 6;
            double dx = c[next] - c[k];
            double dy = c[next + 1] - c[k + 1];
            double inside = turn * (dx * (y - c[k + 1]) - dy * (x - c[k]));
            if (inside < -Math.abs(dx) - Math.abs(dy)) return false;
        }
        return true;
    }

    private static int pixel(double place, int size) {
        return Math.min(size - 1, (int) (place * size));
    }

    private int at(int point) {
        return picture.argb()[
                pixel(places[2 * point + 1], picture.height()) * picture.width()
                        + pixel(places[2 * point], picture.width())];
    }

    /** Difference between what is seen without the image and with it, in % of white over all of the surface. */
    double differenceFromPlain() {
        double sum = 0;
        for (int i = 0; i < count; i++) sum += uses.get(useOf[i]).differenceFromPlain(at(i));
        return percent(sum);
    }

    /** The same for a smaller picture, drawn smoothly. */
    double differenceFrom(int[] argb, int width, int height) {
        double sum = 0;
        for (int i = 0; i < count; i++) {
            double x = Math.max(0, Math.min(width - 1, places[2 * i] * width - .5));
            double y = Math.max(0, Math.min(height - 1, places[2 * i + 1] * height - .5));
            sum += uses.get(useOf[i]).difference(at(i), smooth(argb, width, height, x, y));
        }
        return percent(sum);
    }

    private static int smooth(int[] argb, int width, int height, double x, double y) {
        int x0 = (int) x;
        int y0 = (int) y;
        int x1 = Math.min(width - 1, x0 + 1);
        int y1 = Math.min(height - 1, y0 + 1);
        double fx = x - x0;
        double fy = y - y0;
        int mixed = 0;
        for (int shift = 0; shift <= 24; shift += 8) {
            double upper =
                    (1 - fx) * (argb[y0 * width + x0] >>> shift & 255) + fx * (argb[y0 * width + x1] >>> shift & 255);
            double lower =
                    (1 - fx) * (argb[y1 * width + x0] >>> shift & 255) + fx * (argb[y1 * width + x1] >>> shift & 255);
            mixed |= (int) ((1 - fy) * upper + fy * lower + .5) << shift;
        }
        return mixed;
    }

    private static double percent(double sum) {
        return 100 * sum / 255 / PaintedPoints.POINTS;
    }

    /** Does the preview need opacity? */
    boolean hasAlpha() {
        if (uses.stream().noneMatch(ImageUse::needsAlpha)) return false;
        for (int i = 0; i < covered.length; i++) if (covered[i] && picture.argb()[i] >>> 24 != OPAQUE) return true;
        return false;
    }

    /**
     * What the stages of a preview show, the coarsest first. The finest one has the mean colours of the covered pixels.
     * A pixel of each other one is the mean of those of its four that any face covers; the others may have any colour.
     *
     * @param width of the first stage
     * @param height of the first stage
     * @param isSharp whether to sharpen the finest stage
     */
    List<PreviewRaster> rasters(int width, int height, int stages, boolean isSharp) {
        PreviewRaster raster =
                PreviewRaster.of(picture, covered, width << stages - 1, height << stages - 1, hasAlpha());
        if (isSharp) raster = raster.sharp();
        List<PreviewRaster> list = new ArrayList<>(List.of(raster));
        while (list.size() < stages) list.add(0, list.get(0).half());
        return list;
    }
}
