package org.jsmesh.files.gltf.json;

import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** The format of an image, told by its first bytes, or else by what the file says. */
public enum ImageType {
    PNG("image/png", "png", "", "\u0089PNG"),
    JPEG("image/jpeg", "jpg", "", "\u00ff\u00d8"),
    WEBP("image/webp", "webp", "EXT_texture_webp", "RIFF"),
    KTX2("image/ktx2", "ktx2", "KHR_texture_basisu", "\u00abKTX 20"),
    AVIF("image/avif", "avif", "EXT_texture_avif", "....ftypavif"),
    DDS("image/vnd-ms.dds", "dds", "MSFT_texture_dds", "DDS "),
    GIF("image/gif", "gif", "", "GIF8"),
    BMP("image/bmp", "bmp", "", "BM"),
    OTHER("application/octet-stream", "", "", "");

    /** The extension of PNG within whose header a byte says whether there is opacity. */
    private static final int PNG_COLOUR_TYPE = 25;

    private static final int PNG_ALPHA = 4;

    private final String mimeType;
    private final String suffix;
    private final String extension;
    private final String start;

    ImageType(String mimeType, String suffix, String extension, String start) {
        this.mimeType = mimeType;
        this.suffix = suffix;
        this.extension = extension;
        this.start = start;
    }

    /** By the first bytes. */
    public static ImageType of(byte[] image) {
        String head = new String(image, 0, Math.min(16, image.length), StandardCharsets.ISO_8859_1);
        for (ImageType type : values()) if (type.starts(head)) return type;
        return OTHER;
    }

    /** By the MIME type that a file gives. */
    public static ImageType named(String mimeType) {
        for (ImageType type : values()) if (type.mimeType.equals(mimeType)) return type;
        return mimeType.equals("image/jpg") ? JPEG : OTHER;
    }

    private boolean starts(String head) {
        if (head.length() < start.length()) return false;
        for (int i = 0; i < start.length(); i++)
            if (start.charAt(i) != '.' && start.charAt(i) != head.charAt(i)) return false;
        return this != WEBP || head.startsWith("WEBP", 8);
    }

    /** As glTF names it. */
    public String mimeType() {
        return mimeType;
    }

    /** What a name of such an image ends in, with the dot. Any will do when nobody knows the right one. */
    public String suffix() {
        return this == OTHER ? ".png" : '.' + suffix;
    }

    /** Whether a name ends as that of such an image does. */
    public boolean isEndOf(String name) {
        if (this == OTHER) return name.matches("(?s).*\\.[A-Za-z0-9]{2,5}");
        String lower = name.toLowerCase(Locale.ROOT);
        return lower.endsWith('.' + suffix) || this == JPEG && lower.endsWith(".jpeg");
    }

    /** The extension of glTF by which a texture has such an image; empty where none is needed, or there is none. */
    public String extension() {
        return extension;
    }

    /** Whether glTF has such images. */
    public boolean isKnown() {
        return this == PNG || this == JPEG || !extension.isEmpty();
    }

    /** Whether a PNG has colours with opacity (color type 4 or 6). */
    public static boolean hasAlpha(byte[] image) {
        return image.length > PNG_COLOUR_TYPE && of(image) == PNG && (image[PNG_COLOUR_TYPE] & PNG_ALPHA) != 0;
    }
}
