package org.jsmesh.poster;

import org.jsmesh.display.LinearLight;
import org.jsmesh.mesh.Picture;
import org.jsmesh.studio.Opacity;

/** An image of a material with the smaller ones that stand for it far away, each made when it is first needed. */
final class Image {
    /** Linear light of a byte of sRGB. */
    private static final float[] LINEAR = new float[256];

    static {
        for (int i = 0; i < LINEAR.length; i++) LINEAR[i] = (float) LinearLight.light(i / 255.);
    }

    final int width;
    final int height;
    private final int[] argb;
    private final boolean isColour;
    private Image half;

    private Image(int width, int height, int[] argb, boolean isColour) {
        this.width = width;
        this.height = height;
        this.argb = argb;
        this.isColour = isColour;
    }

    /** An image whose numbers are sRGB. */
    static Image ofColours(Picture picture) {
        return new Image(picture.width(), picture.height(), picture.argb(), true);
    }

    /** An image whose numbers mean what they are. */
    static Image ofNumbers(Picture picture) {
        return new Image(picture.width(), picture.height(), picture.argb(), false);
    }

    /** Opacity that an image says as a mask, as alpha: its own, or its brightness where it has none. */
    static Image ofMask(Picture picture) {
        if (Opacity.of(picture.argb()) != Opacity.OPAQUE) return ofNumbers(picture);
        int[] mask = new int[picture.argb().length];
        for (int i = 0; i < mask.length; i++) {
            int p = picture.argb()[i];
            double bright = .2126 * (p >> 16 & 255) + .7152 * (p >> 8 & 255) + .0722 * (p & 255);
            mask[i] = (int) (bright + .5) << 24;
        }
        return new Image(picture.width(), picture.height(), mask, false);
    }

    Opacity opacity() {
        return Opacity.of(argb);
    }

    /** The image for a surface of which a pixel of the picture covers some pixels of this one. */
    Image of(double pixels) {
        Image image = this;
        for (double left = pixels; left > 2 && image.width + image.height > 2; left /= 4) image = image.half();
        return image;
    }

    private Image half() {
        if (half == null) half = halved();
        return half;
    }

    private Image halved() {
        int w = Math.max(1, width / 2);
        int h = Math.max(1, height / 2);
        int[] small = new int[w * h];
        double[] sum = new double[4];
        for (int i = 0; i < small.length; i++) {
            java.util.Arrays.fill(sum, 0);
            int x = i % w * 2;
            int y = i / w * 2;
            for (int k = 0; k < 4; k++)
                add(argb[Math.min(height - 1, y + k / 2) * width + Math.min(width - 1, x + k % 2)], .25, sum);
            small[i] = level(sum[3], false) << 24
                    | level(sum[0], isColour) << 16
                    | level(sum[1], isColour) << 8
                    | level(sum[2], isColour);
        }
        return new Image(w, h, small, isColour);
    }

    private static int level(double number, boolean isColour) {
        return isColour ? LinearLight.level(number) : (int) (255 * number + .5);
    }

    private void add(int pixel, double weight, double[] sum) {
        for (int k = 0; k < 3; k++) {
            int value = pixel >> 16 - 8 * k & 255;
            sum[k] += weight * (isColour ? LINEAR[value] : value / 255.);
        }
        sum[3] += weight * (pixel >>> 24) / 255.;
    }

    /**
     * The mean of the four pixels around a place, each of red, green, blue, opacity 0 to 1 and colours in linear light.
     *
     * @param u place in widths from the left edge
     * @param v place in heights from the upper edge
     */
    void at(double u, double v, Wrapping wrapping, double[] rgba) {
        double x = u * width - .5;
        double y = v * height - .5;
        if (wrapping.isNearest()) {
            x = Math.floor(x + .5);
            y = Math.floor(y + .5);
        }
        double left = Math.floor(x);
        double above = Math.floor(y);
        double right = x - left;
        double below = y - above;
        int x0 = Wrapping.place(left, width, wrapping.u());
        int x1 = Wrapping.place(left + 1, width, wrapping.u());
        int y0 = Wrapping.place(above, height, wrapping.v());
        int y1 = Wrapping.place(above + 1, height, wrapping.v());
        java.util.Arrays.fill(rgba, 0);
        add(argb[y0 * width + x0], (1 - right) * (1 - below), rgba);
        add(argb[y0 * width + x1], right * (1 - below), rgba);
        add(argb[y1 * width + x0], (1 - right) * below, rgba);
        add(argb[y1 * width + x1], right * below, rgba);
    }

    /**
     * What there is between pixels and outside the image.
     *
     * @param u as glTF numbers it, across
     * @param v likewise, down
     * @param isNearest whether each place has the colour of one pixel
     */
    record Wrapping(int u, int v, boolean isNearest) {
        private static final int CLAMP = 33071;
        private static final int MIRROR = 33648;

        private static int place(double at, int size, int kind) {
            if (kind == CLAMP) return (int) Math.max(0, Math.min(size - 1, at));
            double period = kind == MIRROR ? 2.0 * size : size;
            int place = (int) (at - Math.floor(at / period) * period);
            if (place < 0 || place >= period) return 0; // of numbers too large to count by one
            return place < size ? place : 2 * size - 1 - place;
        }
    }
}
