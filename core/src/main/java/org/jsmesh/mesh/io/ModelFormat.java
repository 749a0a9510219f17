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

    /** {@return the extension of file names, without the dot, lower case} */
    public String extension() {
        return extension;
    }

    /**
     * The format that a file's name promises. It tells models from other files; a reader must not trust it.
     *
     * @param fileName with or without folders, in upper or lower case
     * @return the format to expect, or null when the name promises no model
     */
    public static ModelFormat ofName(String fileName) {
        return isGltfText(fileName) ? GLB : toWrite(fileName);
    }

    /**
     * The format to write under a file's name. glTF is also read as JSON, but written in its binary container only.
     *
     * @param fileName with or without folders, in upper or lower case
     * @return the format of the extension, or null when nothing is written under such a name
     */
    public static ModelFormat toWrite(String fileName) {
        String name = fileName.toLowerCase(Locale.ROOT);
        for (ModelFormat format : values()) {
            if (name.endsWith('.' + format.extension)) return format;
        }
        return null;
    }

    /**
     * Recognizes the JSON form of glTF.
     *
     * @param fileName with or without folders
     * @return true when the name promises it
     */
    public static boolean isGltfText(String fileName) {
        return fileName.toLowerCase(Locale.ROOT).endsWith(".gltf");
    }
}
