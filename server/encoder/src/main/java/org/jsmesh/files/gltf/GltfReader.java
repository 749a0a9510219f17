package org.jsmesh.files.gltf;

import java.io.IOException;
import org.jsmesh.files.gltf.read.SceneReader;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.jsmesh.mesh.io.ResourceResolver;

/** Reads glTF 2.0, GLB or JSON, as {@link SceneReader} says. */
public final class GltfReader {
    private GltfReader() {}

    /**
     * @param fileName for messages
     * @param content the whole file
     * @param resources finds the buffers and images that are not within the file
     * @throws ModelFormatException when the content is not glTF 2.0 or damaged
     * @throws IOException when a resource cannot be read
     */
    public static ModelFile read(String fileName, byte[] content, ResourceResolver resources) throws IOException {
        return read(fileName, content, resources, Integer.MAX_VALUE);
    }

    /**
     * @param fileName for messages
     * @param content the whole file
     * @param resources finds the buffers and images that are not within the file
     * @param mostFaces that the model may have; one that has more is refused before its nodes are expanded
     * @throws ModelFormatException when the content is not glTF 2.0 or damaged, or the model has more faces
     * @throws IOException when a resource cannot be read
     */
    public static ModelFile read(String fileName, byte[] content, ResourceResolver resources, int mostFaces)
            throws IOException {
        return SceneReader.read(fileName, content, resources, mostFaces);
    }
}
