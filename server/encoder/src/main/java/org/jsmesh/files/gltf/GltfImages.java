package org.jsmesh.files.gltf;

import de.javagl.jgltf.impl.v2.Image;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The images of a glTF file by path: the path of a file beside it, or a name for bytes within it. */
final class GltfImages {
    private final GltfDocument document;
    private final Map<String, Integer> images = new HashMap<>();
    private final Map<Integer, String> paths = new HashMap<>();

    GltfImages(GltfDocument document) {
        this.document = document;
        List<Image> list = document.gltf().getImages() == null
                ? List.of()
                : document.gltf().getImages();
        for (int i = 0; i < list.size(); i++) {
            if (list.get(i) == null) continue;
            String path = path(list.get(i), i);
            if (images.containsKey(path) && isWithin(list.get(i))) path = i + "-" + path;
            images.putIfAbsent(path, i);
            paths.put(i, path);
        }
    }

    private static boolean isWithin(Image image) {
        return image.getUri() == null || image.getUri().startsWith("data:");
    }

    private static String path(Image image, int index) {
        if (!isWithin(image)) return GltfDocument.path(image.getUri());
        String name = image.getName() == null || image.getName().isBlank() ? "image" + index : image.getName();
        String type = image.getMimeType();
        if (type == null && image.getUri() != null && image.getUri().startsWith("data:image/jpeg")) type = "image/jpeg";
        boolean hasExtension = name.matches("(?s).*\\.[A-Za-z0-9]{2,5}");
        return hasExtension ? name : name + ("image/jpeg".equals(type) ? ".jpg" : ".png");
    }

    String path(int image) throws IOException {
        document.get(document.gltf().getImages(), image, "image");
        return paths.get(image);
    }

    /** The bytes of an image, or of a file beside the model when no image has this path. */
    Optional<byte[]> bytes(String path) throws IOException {
        Integer index = images.get(path);
        if (index == null) return document.resource(path);
        Image image = document.gltf().getImages().get(index);
        if (image.getUri() != null) return document.resource(image.getUri());
        if (image.getBufferView() == null) return Optional.empty();
        ByteBuffer view = document.view(image.getBufferView());
        byte[] bytes = new byte[view.remaining()];
        view.get(bytes);
        return Optional.of(bytes);
    }
}
