package org.jsmesh.app.bench;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.jsmesh.display.Raster;
import org.jsmesh.display.TextureUse;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** Colours of a model's images at texture coordinates. Skips images of kinds that Java cannot read. */
final class ImageSamples {
    private static final int REPEAT = 10497;
    private static final int MIRRORED = 33648;
    private final Map<String, BufferedImage> images;

    private ImageSamples(Map<String, BufferedImage> images) {
        this.images = new HashMap<>(images);
    }

    ImageSamples(List<Texture> textures) throws IOException {
        images = new HashMap<>();
        for (Texture t : textures) {
            Raster tga = Raster.ofTga(t.bytes());
            byte[] file = tga == null ? t.bytes() : tga.png();
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(file));
            if (image != null) images.put(t.path(), image);
        }
    }

    /** The same images, with pictures in place of some of them. */
    ImageSamples with(List<Picture> pictures) {
        ImageSamples other = new ImageSamples(images);
        for (Picture p : pictures) {
            BufferedImage image = new BufferedImage(p.width(), p.height(), BufferedImage.TYPE_INT_ARGB);
            image.setRGB(0, 0, p.width(), p.height(), p.argb(), 0, p.width());
            other.images.put(p.path(), image);
        }
        return other;
    }

    boolean has(String path) {
        return images.containsKey(path);
    }

    /**
     * The colour at a place, mixed of the four pixels around it.
     *
     * @param use of the image
     * @param x in widths from the left edge; the sampler says what is outside
     * @param y in heights from the upper edge
     * @param rgba takes red, green, blue, opacity, 0 to 1
     */
    void sample(TextureUse use, double x, double y, double[] rgba) {
        BufferedImage image = images.get(use.path());
        double column = x * image.getWidth() - .5;
        double row = y * image.getHeight() - .5;
        Arrays.fill(rgba, 0);
        for (int k = 0; k < 4; k++) {
            double left = Math.floor(column);
            double top = Math.floor(row);
            double weight = (k % 2 == 0 ? 1 - (column - left) : column - left) * (k < 2 ? 1 - (row - top) : row - top);
            int argb = image.getRGB(
                    inside(left + k % 2, image.getWidth(), use.sampler().wrapU()),
                    inside(top + (k >> 1), image.getHeight(), use.sampler().wrapV()));
            for (int c = 0; c < 4; c++) rgba[c] += weight * (argb >> (c == 3 ? 24 : 16 - 8 * c) & 255) / 255;
        }
    }

    private static int inside(double pixel, int size, int wrap) {
        double times = Math.floor(pixel / size);
        int within = (int) Math.max(0, Math.min(size - 1, pixel - times * size));
        if (wrap == REPEAT) return within;
        if (wrap == MIRRORED) return times % 2 == 0 ? within : size - 1 - within;
        return (int) Math.max(0, Math.min(size - 1, pixel));
    }
}
