package org.jsmesh.poster;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;
import org.jsmesh.display.Slot;
import org.jsmesh.mesh.Picture;
import org.jsmesh.studio.Opacity;

/** The images of a model, each read once for what it is used for. */
final class Images {
    private final Map<String, Picture> pictures;
    private final Map<String, Image> colours = new HashMap<>();
    private final Map<String, Image> numbers = new HashMap<>();
    private final Map<String, Image> masks = new HashMap<>();
    private final Map<Image, Opacity> opacities = new HashMap<>();

    /** @param pictures by the path of their image */
    Images(Map<String, Picture> pictures) {
        this.pictures = pictures;
    }

    /** The image of a path, or null when it could not be read. */
    Image of(Slot slot, String path) {
        return switch (slot) {
            case COLOUR, EMISSION -> of(colours, path, Image::ofColours);
            case OPACITY -> of(masks, path, Image::ofMask);
            default -> of(numbers, path, Image::ofNumbers);
        };
    }

    private Image of(Map<String, Image> known, String path, Function<Picture, Image> read) {
        Picture picture = pictures.get(path);
        return picture == null ? null : known.computeIfAbsent(path, p -> read.apply(picture));
    }

    Opacity opacity(Image image) {
        return opacities.computeIfAbsent(image, Image::opacity);
    }
}
