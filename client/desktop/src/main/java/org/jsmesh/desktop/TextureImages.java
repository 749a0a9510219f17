package org.jsmesh.desktop;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** Decodes the textures of meshes, each image once for all snapshots of a session. Used by one thread at a time. */
final class TextureImages {
    /** Images that claim more pixels are not decoded, because 256 megapixels would take a gigabyte. */
    private static final long MOST_PIXELS = 1 << 28;

    private final Map<String, Optional<TextureImage>> decoded = new HashMap<>();
    private final Map<String, TextureImage> previews = new HashMap<>();
    private String problem;

    /** Images, by path, of the textures that have arrived and can be decoded, and previews of the others. */
    Map<String, TextureImage> of(Mesh mesh) {
        Map<String, TextureImage> images = new LinkedHashMap<>();
        for (Texture texture : mesh.textures()) {
            decoded.computeIfAbsent(texture.path(), path -> decode(texture))
                    .ifPresent(image -> images.put(texture.path(), image));
        }
        for (Picture preview : mesh.previews()) {
            TextureImage known = previews.get(preview.path());
            if (known == null || known.width() != preview.width()) previews.put(preview.path(), opaque(preview));
            images.put(preview.path(), previews.get(preview.path()));
        }
        return images;
    }

    private static TextureImage opaque(Picture picture) {
        int[] argb = picture.rgb().clone();
        for (int i = 0; i < argb.length; i++) argb[i] |= 0xff000000;
        return new TextureImage(picture.width(), picture.height(), argb);
    }

    /** Why an image could not be decoded, or null. */
    String problem() {
        return problem;
    }

    private Optional<TextureImage> decode(Texture texture) {
        try {
            BufferedImage image = read(texture.bytes());
            int width = image.getWidth();
            int height = image.getHeight();
            return Optional.of(new TextureImage(width, height, image.getRGB(0, 0, width, height, null, 0, width)));
        } catch (IOException | RuntimeException e) {
            // Image plug-ins throw many kinds of exceptions for broken files.
            problem = "The texture " + texture.path() + " cannot be shown: " + e.getMessage();
            return Optional.empty();
        }
    }

    private static BufferedImage read(byte[] bytes) throws IOException {
        try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            if (!readers.hasNext()) throw new IOException("it is not a PNG, JPEG, GIF, BMP or TIFF image");
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
