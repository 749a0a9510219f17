package org.jsmesh.mesh.io;

import java.util.Locale;
import org.jsmesh.mesh.UpAxis;

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
    GLB("glb"),
    /** 3D Manufacturing Format; read, not written. */
    THREE_MF("3mf");

    private static final String GZIP = ".gz";

    private final String extension;

    ModelFormat(String extension) {
        this.extension = extension;
    }

    /** {@return the extension of file names, without the dot, lower case} */
    public String extension() {
        return extension;
    }

    /** {@return the name of the format for people} */
    public String title() {
        return switch (this) {
            case HOPPE_M -> "Hoppe .m";
            case GLB -> "glTF";
            default -> extension.toUpperCase(Locale.ROOT);
        };
    }

    /** {@return the axis that points up in every file of the format; unknown when the format does not say} */
    public UpAxis up() {
        if (this == GLB) return UpAxis.Y;
        return this == THREE_MF ? UpAxis.Z : UpAxis.UNKNOWN;
    }

    /**
     * The format that a file's name promises. It tells models from other files; a reader must not trust it. The file
     * may be packed with gzip, as {@code chair.ply.gz}.
     *
     * @param fileName with or without folders, in upper or lower case
     * @return the format to expect, or null when the name promises no model
     */
    public static ModelFormat ofName(String fileName) {
        String name = withoutGzip(fileName);
        return isGltfText(name) ? GLB : ofExtension(name);
    }

    /**
     * The name of the file that a gzip file holds.
     *
     * @param fileName with or without folders, in upper or lower case
     * @return the name without {@code .gz}, or the name itself where it does not end so
     */
    public static String withoutGzip(String fileName) {
        boolean packed = fileName.toLowerCase(Locale.ROOT).endsWith(GZIP);
        return packed ? fileName.substring(0, fileName.length() - GZIP.length()) : fileName;
    }

    /**
     * The format to write under a file's name. glTF is also read as JSON, but written in its binary container only. 3MF
     * is not written.
     *
     * @param fileName with or without folders, in upper or lower case
     * @return the format of the extension, or null when nothing is written under such a name
     */
    public static ModelFormat toWrite(String fileName) {
        ModelFormat format = ofExtension(fileName);
        return format == THREE_MF ? null : format;
    }

    private static ModelFormat ofExtension(String fileName) {
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
