package org.jsmesh.test.material;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/**
 * A small model that shows one property of a material.
 *
 * @param name of the property
 * @param files of the model by their names, which begin with that of the property
 * @param reference the GLB file that a reference viewer is to draw: the model itself, or the same surface in other
 *     words
 * @param without a GLB file of the same shape that lacks the property, so that a test can see whether it shows
 */
public record MaterialModel(String name, Map<String, byte[]> files, byte[] reference, byte[] without) {
    MaterialModel(String name, GlbScene with, GlbScene without) {
        this(name, with, with, without);
    }

    MaterialModel(String name, GlbScene with, GlbScene reference, GlbScene without) {
        this(name, Map.of(name + ".glb", with.bytes()), reference.bytes(), without.bytes());
    }

    /** The file of a model in glTF. */
    public byte[] glb() {
        return files.get(name + ".glb");
    }

    /** Puts the files of the model into a folder. */
    public void write(Path folder) throws IOException {
        for (Map.Entry<String, byte[]> file : files.entrySet())
            Files.write(folder.resolve(file.getKey()), file.getValue());
    }

    @Override
    public String toString() {
        return name;
    }
}
