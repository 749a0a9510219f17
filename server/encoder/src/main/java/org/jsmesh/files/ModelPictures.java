package org.jsmesh.files;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.apache.commons.imaging.Imaging;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * Small pictures of what the textures of a model show, for the encoder. They are read in Java alone, so that the same
 * file gives the same colours, and archives the same bytes, everywhere.
 */
public final class ModelPictures {
    /** Longer side of a picture; no preview has more pixels. */
    private static final int SIDE = 512;

    /** Larger images would need too much memory. */
    private static final long MOST_PIXELS = 1L << 26;

    private ModelPictures() {}

    /**
     * Reads those textures that viewers show. Images that are damaged, too large or of an unknown kind give no picture.
     *
     * @param mesh with its materials and textures
     * @return pictures in the order of the textures; larger images are reduced to at most 512 pixels a side,
     *     progressive JPEG to an eighth
     */
    public static List<Picture> of(Mesh mesh) {
        Set<String> shown = new HashSet<>();
        for (Material m : mesh.materials()) shown.add(m.displayTexture());
        List<Picture> pictures = new ArrayList<>();
        for (Texture t : mesh.textures()) {
            Picture picture = shown.contains(t.path()) ? read(t) : null;
            if (picture != null) pictures.add(picture);
        }
        return pictures;
    }

    private static Picture read(Texture texture) {
        try {
            if (ProgressiveJpeg.is(texture.bytes())) return ProgressiveJpeg.read(texture.path(), texture.bytes());
            Dimension size = Imaging.getImageSize(texture.bytes());
            if (size == null || size.width < 1 || size.height < 1 || (long) size.width * size.height > MOST_PIXELS)
                return null;
            BufferedImage image = Imaging.getBufferedImage(texture.bytes());
            return image == null ? null : smaller(texture.path(), image);
        } catch (IOException | RuntimeException e) {
            // The library has many exceptions for a file that is damaged or of an unknown kind.
            return null;
        }
    }

    /** Means of whole pixels. */
    private static Picture smaller(String path, BufferedImage image) {
        int factor = (Math.max(image.getWidth(), image.getHeight()) + SIDE - 1) / SIDE;
        int width = (image.getWidth() + factor - 1) / factor;
        int height = (image.getHeight() + factor - 1) / factor;
        int[] rgb = new int[width * height];
        int[] row = new int[image.getWidth()];
        long[] sums = new long[3 * width];
        for (int y = 0; y < height; y++) {
            int rows = Math.min(factor, image.getHeight() - y * factor);
            java.util.Arrays.fill(sums, 0);
            for (int r = 0; r < rows; r++) {
                image.getRGB(0, y * factor + r, row.length, 1, row, 0, row.length);
                for (int x = 0; x < row.length; x++)
                    for (int k = 0; k < 3; k++) sums[3 * (x / factor) + k] += row[x] >> 16 - 8 * k & 255;
            }
            for (int x = 0; x < width; x++) {
                int count = rows * Math.min(factor, row.length - x * factor);
                for (int k = 0; k < 3; k++)
                    rgb[y * width + x] = rgb[y * width + x] << 8 | (int) ((sums[3 * x + k] + count / 2) / count);
            }
        }
        return new Picture(path, width, height, rgb);
    }
}
