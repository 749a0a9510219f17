package org.jsmesh.app.bench;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** Colours of a model's images at texture coordinates. Skips images of kinds that Java cannot read. */
final class ImageSamples {
    private final Map<String, BufferedImage> images;

    private ImageSamples(Map<String, BufferedImage> images) {
        this.images = new HashMap<>(images);
    }

    ImageSamples(List<Texture> textures) throws IOException {
        images = new HashMap<>();
        for (Texture t : textures) {
            BufferedImage image = ImageIO.read(new ByteArrayInputStream(t.bytes()));
            if (image != null) images.put(t.path(), image);
        }
    }

    /** The same images, with pictures in place of some of them. */
    ImageSamples with(List<Picture> pictures) {
        ImageSamples other = new ImageSamples(images);
        for (Picture p : pictures) {
            BufferedImage image = new BufferedImage(p.width(), p.height(), BufferedImage.TYPE_INT_RGB);
            image.setRGB(0, 0, p.width(), p.height(), p.rgb(), 0, p.width());
            other.images.put(p.path(), image);
        }
        return other;
    }

    boolean has(String path) {
        return images.containsKey(path);
    }

    /**
     * The nearest pixel; images repeat in both directions.
     *
     * @param fromTop true when v counts from the top, as glTF has it
     * @param rgb takes red, green, blue, 0 to 1
     */
    void sample(String path, double u, double v, boolean fromTop, double[] rgb) {
        BufferedImage image = images.get(path);
        double row = fromTop ? v : 1 - v;
        int x = Math.min(image.getWidth() - 1, (int) ((u - Math.floor(u)) * image.getWidth()));
        int y = Math.min(image.getHeight() - 1, (int) ((row - Math.floor(row)) * image.getHeight()));
        int argb = image.getRGB(x, y);
        for (int k = 0; k < 3; k++) rgb[k] = (argb >> 16 - 8 * k & 255) / 255.0;
    }
}
