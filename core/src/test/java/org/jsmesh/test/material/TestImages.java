package org.jsmesh.test.material;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;

/** Images for textures, made by rule. */
final class TestImages {
    private static final int SIDE = 64;
    private static final int FULL = 255;

    private TestImages() {}

    /** A PNG file of which a function of column and row gives the pixels: alpha, red, green, blue. */
    private static byte[] png(int side, IntBinaryOperator pixel) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        for (int y = 0; y < side; y++) for (int x = 0; x < side; x++) image.setRGB(x, y, pixel.applyAsInt(x, y));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try {
            ImageIO.write(image, "png", out);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return out.toByteArray();
    }

    private static int argb(int alpha, int red, int green, int blue) {
        return alpha << 24 | red << 16 | green << 8 | blue;
    }

    /** Red, green, blue and yellow quarters, each darker towards the bottom, so that no turn looks like another. */
    static byte[] quarters() {
        int[] colours = {0xE03020, 0x20C040, 0x3050F0, 0xF0E030};
        return png(SIDE, (x, y) -> {
            int c = colours[2 * (y / (SIDE / 2)) + x / (SIDE / 2)];
            int light = FULL - 2 * (y % (SIDE / 2));
            return argb(
                    FULL, (c >> 16 & FULL) * light / FULL, (c >> 8 & FULL) * light / FULL, (c & FULL) * light / FULL);
        });
    }

    /** Four pixels a side, each of another colour. */
    static byte[] fewPixels() {
        return png(4, (x, y) -> argb(FULL, 80 * x, 80 * y, (x + y) % 2 * FULL));
    }

    /** Columns of colour whose opacity, 0 to 255, takes turns. */
    static byte[] columns(int firstAlpha, int secondAlpha) {
        return png(SIDE, (x, y) -> {
            boolean first = x / 8 % 2 == 0;
            return argb(first ? firstAlpha : secondAlpha, first ? 230 : 40, 120, first ? 30 : 220);
        });
    }

    /** Red, green and blue, each from one value to another across or down the image. */
    static byte[] gradient(int red, int redTo, int green, int greenTo, int blue, int blueTo) {
        int last = SIDE - 1;
        return png(
                SIDE,
                (x, y) -> argb(
                        FULL,
                        red + (redTo - red) * x / last,
                        green + (greenTo - green) * y / last,
                        blue + (blueTo - blue) * x / last));
    }

    /** From black at the top to white at the bottom. */
    static byte[] greys() {
        return png(SIDE, (x, y) -> argb(FULL, 4 * y, 4 * y, 4 * y));
    }

    /** Heights of waves that run to the right. */
    static byte[] waves() {
        return png(SIDE, (x, y) -> {
            int grey = coded(Math.sin(2 * Math.PI * x / 16));
            return argb(FULL, grey, grey, grey);
        });
    }

    /** Bands of white on black, down the image. */
    static byte[] bands() {
        return png(SIDE, (x, y) -> y / 8 % 2 == 0 ? 0xFFFFFFFF : 0xFF000000);
    }

    /** A normal map of slopes to the right and to the left, steeper than those up and down. */
    static byte[] ridges() {
        return png(SIDE, (x, y) -> {
            double right = .75 * Math.sin(2 * Math.PI * x / 16);
            double up = .35 * Math.cos(2 * Math.PI * y / 32);
            double out = Math.sqrt(1 - right * right - up * up);
            return argb(FULL, coded(right), coded(up), coded(out));
        });
    }

    private static int coded(double part) {
        return (int) Math.round((part + 1) / 2 * FULL);
    }
}
