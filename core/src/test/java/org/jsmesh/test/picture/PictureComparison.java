package org.jsmesh.test.picture;

import java.awt.image.BufferedImage;
import java.util.BitSet;

/** How far two pictures of the same size agree. */
public final class PictureComparison {
    private PictureComparison() {}

    /** Pixels that are at least half opaque, row by row. */
    public static BitSet opaque(BufferedImage picture) {
        BitSet mask = new BitSet();
        for (int i = 0; i < picture.getWidth() * picture.getHeight(); i++) {
            if (pixel(picture, i) >>> 24 >= 128) mask.set(i);
        }
        return mask;
    }

    /**
     * Pixels of which a component differs from the same pixel of a picture of the background alone by more than
     * {@code threshold} of 255.
     */
    public static BitSet differing(BufferedImage picture, BufferedImage background, int threshold) {
        checkSizes(picture, background);
        BitSet mask = new BitSet();
        for (int i = 0; i < picture.getWidth() * picture.getHeight(); i++) {
            int a = pixel(picture, i);
            int b = pixel(background, i);
            for (int shift = 0; shift < 24; shift += 8) {
                if (Math.abs((a >> shift & 255) - (b >> shift & 255)) > threshold) mask.set(i);
            }
        }
        return mask;
    }

    /** Pixels in both masks by pixels in either: 1 for equal silhouettes, also for two empty ones. */
    public static double intersectionOverUnion(BitSet a, BitSet b) {
        BitSet both = (BitSet) a.clone();
        both.and(b);
        BitSet either = (BitSet) a.clone();
        either.or(b);
        return either.isEmpty() ? 1 : (double) both.cardinality() / either.cardinality();
    }

    /** Mean difference of the colour components over the pixels of a mask, 0 to 255; opacity is not looked at. */
    public static double meanDifference(BufferedImage a, BufferedImage b, BitSet mask) {
        checkSizes(a, b);
        if (mask.isEmpty()) throw new IllegalArgumentException("no pixel to compare");
        long sum = 0;
        for (int i = mask.nextSetBit(0); i >= 0; i = mask.nextSetBit(i + 1)) {
            int p = pixel(a, i);
            int q = pixel(b, i);
            for (int shift = 0; shift < 24; shift += 8) sum += Math.abs((p >> shift & 255) - (q >> shift & 255));
        }
        return sum / 3.0 / mask.cardinality();
    }

    /**
     * Mean difference of the colour components over the pixels of which either picture is not wholly transparent, 0 to
     * 1: the larger one before black and before white.
     */
    public static double visibleDifference(BufferedImage a, BufferedImage b) {
        checkSizes(a, b);
        double[] sums = new double[2];
        int pixels = 0;
        for (int i = 0; i < a.getWidth() * a.getHeight(); i++) {
            int p = pixel(a, i);
            int q = pixel(b, i);
            if (p >>> 24 == 0 && q >>> 24 == 0) continue;
            pixels++;
            for (int shift = 0; shift < 24; shift += 8) {
                double black = seen(p, shift) - seen(q, shift);
                sums[0] += Math.abs(black);
                sums[1] += Math.abs(black + (q >>> 24) - (p >>> 24));
            }
        }
        if (pixels == 0) throw new IllegalArgumentException("both pictures are blank");
        return Math.max(sums[0], sums[1]) / 3 / 255 / pixels;
    }

    private static double seen(int argb, int shift) {
        return (argb >> shift & 255) * (argb >>> 24) / 255.0;
    }

    /** Standard deviation of the brightness over the pixels of a mask, 0 to 127: 0 for a picture of one colour. */
    public static double contrast(BufferedImage picture, BitSet mask) {
        double sum = 0;
        double squares = 0;
        for (int i = mask.nextSetBit(0); i >= 0; i = mask.nextSetBit(i + 1)) {
            int p = pixel(picture, i);
            double value = ((p >> 16 & 255) + (p >> 8 & 255) + (p & 255)) / 3.0;
            sum += value;
            squares += value * value;
        }
        int n = Math.max(1, mask.cardinality());
        return Math.sqrt(Math.max(0, squares / n - sum / n * (sum / n)));
    }

    private static int pixel(BufferedImage picture, int index) {
        return picture.getRGB(index % picture.getWidth(), index / picture.getWidth());
    }

    private static void checkSizes(BufferedImage a, BufferedImage b) {
        if (a.getWidth() != b.getWidth() || a.getHeight() != b.getHeight()) {
            throw new IllegalArgumentException(
                    a.getWidth() + "×" + a.getHeight() + " and " + b.getWidth() + "×" + b.getHeight() + " pixels");
        }
    }
}
