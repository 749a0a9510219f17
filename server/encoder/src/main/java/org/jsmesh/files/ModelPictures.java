package org.jsmesh.files;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.apache.commons.imaging.Imaging;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.Raster;
import org.jsmesh.display.TextureUse;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * Small pictures of what the textures of a model show, for the encoder. They are read in Java alone, so that the same
 * file gives the same colours, and archives the same bytes, everywhere.
 */
public final class ModelPictures {
    /** Longer side of a picture, four times that of the largest preview. */
    private static final int SIDE = 2048;

    /** Larger images would need too much memory. */
    private static final long MOST_PIXELS = 1L << 26;

    private ModelPictures() {}

    /**
     * Reads those textures that viewers show. Images that are damaged, too large or of an unknown kind give no picture.
     *
     * @param mesh with its materials and textures
     * @return pictures in the order of the textures, one for those with the same bytes; larger images are reduced to at
     *     most 2048 pixels a side
     */
    public static List<Picture> of(Mesh mesh) {
        Set<String> shown = new HashSet<>();
        for (Material m : mesh.materials())
            for (TextureUse use : DisplayMaterial.of(m, false).textures().values()) shown.add(use.path());
        Set<ByteBuffer> known = new HashSet<>();
        List<Picture> pictures = new ArrayList<>();
        for (Texture t : mesh.textures()) {
            if (!shown.contains(t.path()) || !known.add(ByteBuffer.wrap(t.bytes()))) continue;
            Picture picture = read(t);
            if (picture != null) pictures.add(picture);
        }
        return pictures;
    }

    private static Picture read(Texture texture) {
        try {
            if (ProgressiveJpeg.is(texture.bytes()))
                return smaller(texture.path(), ProgressiveJpeg.read(texture.bytes()));
            Raster tga = Raster.ofTga(texture.bytes());
            if (tga != null) return smaller(texture.path(), image(tga));
            byte[] file = PlainPng.of(texture.bytes());
            Dimension size = Imaging.getImageSize(file);
            if (size == null || size.width < 1 || size.height < 1 || (long) size.width * size.height > MOST_PIXELS)
                return null;
            BufferedImage image = Imaging.getBufferedImage(file);
            return image == null ? null : smaller(texture.path(), image);
        } catch (IOException | RuntimeException e) {
            // The library has many exceptions for a file that is damaged or of an unknown kind.
            return null;
        }
    }

    private static BufferedImage image(Raster raster) {
        BufferedImage image = new BufferedImage(raster.width(), raster.height(), BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, raster.width(), raster.height(), raster.argb(), 0, raster.width());
        return image;
    }

    /** Means of whole pixels. Colours count by their opacity. */
    private static Picture smaller(String path, BufferedImage image) {
        int factor = (Math.max(image.getWidth(), image.getHeight()) + SIDE - 1) / SIDE;
        int width = (image.getWidth() + factor - 1) / factor;
        int height = (image.getHeight() + factor - 1) / factor;
        int[] argb = new int[width * height];
        int[] row = new int[image.getWidth()];
        long[] sums = new long[4 * width];
        long[] weights = new long[width];
        for (int y = 0; y < height; y++) {
            int rows = Math.min(factor, image.getHeight() - y * factor);
            Arrays.fill(sums, 0);
            Arrays.fill(weights, 0);
            for (int r = 0; r < rows; r++) {
                image.getRGB(0, y * factor + r, row.length, 1, row, 0, row.length);
                for (int x = 0; x < row.length; x++) {
                    int weight = 1 + (row[x] >>> 24);
                    weights[x / factor] += weight;
                    sums[4 * (x / factor)] += row[x] >>> 24;
                    for (int k = 1; k < 4; k++)
                        sums[4 * (x / factor) + k] += (long) weight * (row[x] >> 24 - 8 * k & 255);
                }
            }
            for (int x = 0; x < width; x++) {
                int count = rows * Math.min(factor, row.length - x * factor);
                int mean = (int) ((sums[4 * x] + count / 2) / count);
                for (int k = 1; k < 4; k++) mean = mean << 8 | (int) ((sums[4 * x + k] + weights[x] / 2) / weights[x]);
                argb[y * width + x] = mean;
            }
        }
        return new Picture(path, width, height, argb);
    }
}
