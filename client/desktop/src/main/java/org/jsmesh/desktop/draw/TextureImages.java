package org.jsmesh.desktop.draw;

import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.jsmesh.display.DisplayMaterial;
import org.jsmesh.display.DisplaySlots;
import org.jsmesh.display.Raster;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** Decodes the textures of meshes, each image once for all snapshots of a session. Used by one thread at a time. */
public final class TextureImages {
    /** Images that claim more pixels are not decoded, because 256 megapixels would take a gigabyte. */
    private static final long MOST_PIXELS = 1 << 28;

    private final Map<String, Optional<TextureImage>> decoded = new HashMap<>();
    private final Map<byte[], Optional<TextureImage>> ofBytes = new IdentityHashMap<>(); // paths share them
    private final Map<String, TextureImage> previews = new HashMap<>();
    private final Map<String, TextureImage> masks = new HashMap<>();
    private String problem;

    /** Images, by path, of the textures that have arrived and can be decoded, and previews of the others. */
    public Map<String, TextureImage> of(Mesh mesh) {
        Map<String, TextureImage> images = new LinkedHashMap<>();
        for (Texture texture : mesh.textures()) {
            decoded.computeIfAbsent(
                            texture.path(), path -> ofBytes.computeIfAbsent(texture.bytes(), b -> decode(texture)))
                    .ifPresent(image -> images.put(texture.path(), image));
        }
        for (Picture preview : mesh.previews()) {
            TextureImage known = previews.get(preview.path());
            if (known == null || known.width() != preview.width())
                previews.put(preview.path(), TextureImage.of(preview.width(), preview.height(), preview.argb()));
            images.put(preview.path(), previews.get(preview.path()));
        }
        return images;
    }

    /** Masks, by path, from those images that have arrived and say the opacity of a material. */
    public Map<String, TextureImage> masks(DisplaySlots slots) {
        Map<String, TextureImage> found = new LinkedHashMap<>();
        for (DisplayMaterial material : slots.materials()) {
            String path = material.image(Slot.OPACITY);
            decoded.getOrDefault(path, Optional.empty())
                    .ifPresent(image -> found.put(path, masks.computeIfAbsent(path, p -> image.mask())));
        }
        return found;
    }

    /** Why an image could not be decoded, or null. */
    public String problem() {
        return problem;
    }

    private Optional<TextureImage> decode(Texture texture) {
        try {
            Raster tga = Raster.ofTga(texture.bytes());
            if (tga != null) return Optional.of(TextureImage.of(tga.width(), tga.height(), tga.argb()));
            BufferedImage image = read(texture.bytes());
            return Optional.of(TextureImage.of(image.getWidth(), image.getHeight(), pixels(image)));
        } catch (IOException | RuntimeException e) {
            // Image plug-ins throw many kinds of exceptions for broken files.
            problem = "The texture " + texture.path() + " cannot be shown: " + e.getMessage();
            return Optional.empty();
        }
    }

    private static int[] pixels(BufferedImage image) {
        int width = image.getWidth();
        int height = image.getHeight();
        boolean isGrey = image.getColorModel().getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        return isGrey ? greys(image) : image.getRGB(0, 0, width, height, null, 0, width);
    }

    /** Java takes shades of grey for linear light and would make them brighter; files mean them as they are. */
    private static int[] greys(BufferedImage image) {
        int width = image.getWidth();
        int[] argb = new int[width * image.getHeight()];
        int bands = image.getRaster().getNumBands();
        double full = (1 << image.getColorModel().getComponentSize(0)) - 1;
        int[] samples = new int[bands * width];
        for (int y = 0; y < image.getHeight(); y++) {
            image.getRaster().getPixels(0, y, width, 1, samples);
            for (int x = 0; x < width; x++) {
                int grey = (int) Math.round(samples[bands * x] / full * 255);
                int alpha = bands > 1 ? (int) Math.round(samples[bands * x + 1] / full * 255) : 255;
                argb[y * width + x] = alpha << 24 | grey << 16 | grey << 8 | grey;
            }
        }
        return argb;
    }

    private static BufferedImage read(byte[] bytes) throws IOException {
        try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) throw new IOException("it is not a PNG, JPEG, GIF, BMP, TIFF or TGA image");
            ImageReader reader = readers.next();
            try {
                reader.setInput(in, true, true);
                long pixels = (long) reader.getWidth(0) * reader.getHeight(0);
                if (pixels > MOST_PIXELS) throw new IOException("it has " + pixels + " pixels");
                return reader.read(0);
            } finally {
                reader.dispose();
            }
        }
    }
}
