package org.jsmesh.mesh.io;

import java.util.Locale;

/** A model file format. */
public enum ModelFormat {
    /** Stanford polygon format, ASCII or binary. */
    PLY("ply"),
    /** Wavefront OBJ with its MTL material libraries. */
    OBJ("obj"),
    /** Stereolithography, ASCII or binary. */
    STL("stl"),
    /** Object file format of Geomview. */
    OFF("off"),
    /** Mesh text format of Hugues Hoppe's progressive meshes. */
    HOPPE_M("m"),
    /** glTF 2.0, binary container (and its JSON form when read); not read by this package but by the encoder module. */
    GLB("glb");

    private final String extension;

    ModelFormat(String extension) {
        this.extension = extension;
    }

    /** File name extension without the dot, lower case. */
    public String extension() {
        return extension;
    }

    /** The format that a file's name promises, or null; to choose a format for writing, never to trust when reading. */
    public static ModelFormat ofName(String fileName) {
        String name = fileName.toLowerCase(Locale.ROOT);
        if (name.endsWith(".gltf")) return GLB;
        for (ModelFormat format : values()) {
            if (name.endsWith('.' + format.extension)) return format;
        }
        return null;
    }
}
