package org.jsmesh.encode.write;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jsmesh.archive.ImageInfo;
import org.jsmesh.mesh.Sha256;
import org.jsmesh.mesh.Texture;

/**
 * An image with all the paths under which a mesh has it. An archive holds it once.
 *
 * @param bytes of the image file, shared
 * @param paths in the order of the mesh
 */
public record SharedImage(byte[] bytes, List<String> paths) {
    /** The images of some textures: one for all those with equal bytes, in the order of the first of them. */
    public static List<SharedImage> of(List<Texture> textures) {
        Map<ByteBuffer, SharedImage> byContent = new LinkedHashMap<>();
        for (Texture t : textures)
            byContent
                    .computeIfAbsent(ByteBuffer.wrap(t.bytes()), b -> new SharedImage(t.bytes(), new ArrayList<>()))
                    .paths
                    .add(t.path());
        return List.copyOf(byContent.values());
    }

    /** The image once more for each of its paths. */
    public List<Texture> textures() {
        return paths.stream().map(path -> new Texture(path, bytes)).toList();
    }

    /** What the header of an archive says of it. */
    ImageInfo info() {
        return new ImageInfo(paths, bytes.length, Sha256.hex(bytes));
    }
}
