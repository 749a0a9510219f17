package org.jsmesh.mesh;

import java.util.Arrays;
import java.util.List;

/**
 * The discrete attribute of a face (D of the paper): a name, numeric parameters and texture references, each under the
 * key of the file it came from ({@code Kd}, {@code Ns}, {@code map_Kd} of MTL; {@code baseColorFactor},
 * {@code baseColorTexture} of glTF; {@code rgb} of Hoppe's .m). Equality is of raw float bits; the order of parameters
 * is kept and counts.
 */
public record Material(String name, List<Parameter> parameters, List<TextureReference> textures) {
    public Material {
        parameters = List.copyOf(parameters);
        textures = List.copyOf(textures);
    }

    /** A numeric parameter, for instance {@code Kd} with three values. */
    public record Parameter(String key, float... values) {
        public Parameter {
            values = values.clone();
        }

        @Override
        public float[] values() {
            return values.clone();
        }

        @Override
        public boolean equals(Object o) {
            if (!(o instanceof Parameter p) || !key.equals(p.key) || values.length != p.values.length) return false;
            for (int i = 0; i < values.length; i++) {
                if (Float.floatToRawIntBits(values[i]) != Float.floatToRawIntBits(p.values[i])) return false;
            }
            return true;
        }

        @Override
        public int hashCode() {
            return 31 * key.hashCode() + Arrays.hashCode(values);
        }
    }

    /** A texture, by the path that the model file gives, for instance {@code map_Kd wood.png}. */
    public record TextureReference(String key, String path) {}

    public static Material named(String name) {
        return new Material(name, List.of(), List.of());
    }

    /** The values under a key, or null. */
    public float[] parameter(String key) {
        for (Parameter p : parameters) {
            if (p.key.equals(key)) return p.values();
        }
        return null;
    }

    /** Red, green, blue, opacity (0..1) to draw with: base colour, diffuse colour or light grey. */
    public float[] displayColour() {
        float[] base = parameter("baseColorFactor");
        if (base != null && base.length == 4) return base;
        float[] rgb = parameter("Kd");
        if (rgb == null) rgb = parameter("rgb");
        if (rgb == null || rgb.length != 3) rgb = new float[] {.8f, .8f, .8f};
        float[] opacity = parameter("d");
        return new float[] {rgb[0], rgb[1], rgb[2], opacity == null || opacity.length != 1 ? 1f : opacity[0]};
    }

    /** Path of the colour texture to draw with, or null. */
    public String displayTexture() {
        for (TextureReference t : textures) {
            if (t.key.equals("map_Kd") || t.key.equals("baseColorTexture")) return t.path;
        }
        return null;
    }
}
