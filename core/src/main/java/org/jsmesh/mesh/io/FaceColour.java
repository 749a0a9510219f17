package org.jsmesh.mesh.io;

/** Materials that only give the colour of a face, as in OFF and Hoppe's .m; their names say the colour. */
final class FaceColour {
    private static final String PREFIX = "rgb=";

    private FaceColour() {}

    static String name(float[] rgb) {
        return PREFIX + text(rgb);
    }

    /** {@code (1 0.5 0)}: the shortest text that reads back to the same bits. */
    static String text(float[] rgb) {
        StringBuilder text = new StringBuilder("(");
        for (int i = 0; i < rgb.length; i++) {
            if (i > 0) text.append(' ');
            text.append(FloatText.plain(rgb[i]));
        }
        return text.append(')').toString();
    }
}
