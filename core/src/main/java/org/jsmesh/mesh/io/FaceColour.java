package org.jsmesh.mesh.io;

import java.util.List;
import org.jsmesh.mesh.Material;

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

    /** Whether a material is a colour and nothing else. */
    static boolean is(Material material) {
        return isOnlyColour(material.parameters())
                && material.textures().isEmpty()
                && material.name().equals(name(material.parameter("rgb")));
    }

    /** Whether the parameters are {@code rgb} and perhaps {@code d}. */
    static boolean isOnlyColour(List<Material.Parameter> parameters) {
        List<String> keys = parameters.stream().map(Material.Parameter::key).toList();
        if (!keys.equals(List.of("rgb")) && !keys.equals(List.of("rgb", "d"))) return false;
        return parameters.get(0).values().length == 3
                && (keys.size() == 1 || parameters.get(1).values().length == 1);
    }

    /** Whether a number is a whole number of parts of 1, bit for bit. */
    static boolean isPart(float value, int parts) {
        if (!(value >= 0 && value <= 1)) return false;
        return Float.floatToIntBits(Math.round(value * parts) / (float) parts) == Float.floatToIntBits(value);
    }
}
