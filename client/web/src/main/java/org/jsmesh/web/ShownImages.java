package org.jsmesh.web;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.display.Raster;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/** The images of a mesh that can be shown. One that has several paths is there once. */
final class ShownImages {
    private final List<Image> images = new ArrayList<>();

    /** Either the bytes of a file or a preview. */
    private record Image(List<String> paths, byte[] bytes, Picture preview) {}

    ShownImages(Mesh mesh) {
        for (Texture t : mesh.textures()) {
            Image last = last();
            if (last == null || last.bytes != t.bytes())
                images.add(last = new Image(new ArrayList<>(), t.bytes(), null));
            last.paths.add(t.path());
        }
        for (Picture p : mesh.previews()) {
            Image last = last();
            if (last == null || last.preview == null || last.preview.argb() != p.argb())
                images.add(last = new Image(new ArrayList<>(), null, p));
            last.paths.add(p.path());
        }
    }

    private Image last() {
        return images.isEmpty() ? null : images.get(images.size() - 1);
    }

    /**
     * Writes a list of the images: those that have arrived whole, then previews of others. Each has the paths of its
     * textures and its width in pixels, which is null where the file itself says it.
     */
    void write(Json json) {
        json.open('[');
        for (Image image : images) {
            json.open('{').key("paths").open('[');
            for (String path : image.paths) json.text(path);
            json.close(']').key("width");
            if (image.preview == null) json.text(null);
            else json.number(image.preview.width());
            json.close('}');
        }
        json.close(']');
    }

    /** The image at a place in that list, as a file that browsers read. */
    byte[] file(int index) {
        if (index < 0 || index >= images.size())
            throw new WrongCallException("there is no image " + index + " of " + images.size());
        Image image = images.get(index);
        Picture p = image.preview;
        if (p != null) return new Raster(p.width(), p.height(), p.argb()).png();
        Raster tga = Raster.ofTga(image.bytes);
        return tga == null ? image.bytes : tga.png();
    }
}
