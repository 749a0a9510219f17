package org.jsmesh.mesh;

import java.util.Arrays;
import java.util.List;

/**
 * The discrete attribute of a face (D of the paper): a name, numeric parameters and texture references, each under the
 * key of the file it came from ({@code Kd}, {@code Ns}, {@code map_Kd} of MTL; {@code baseColorFactor},
 * {@code baseColorTexture} of glTF; {@code rgb} of Hoppe's .m). Equality is of raw float bits; the order of parameters
 * is kept and counts.
 *
 * @param name as the model file gives it; several materials may share one
 * @param parameters in the order of the file
 * @param textures in the order of the file
 */
public record Material(String name, List<Parameter> parameters, List<TextureReference> textures) {
    /**
     * Copies the lists.
     *
     * @param name see {@link #name()}
     * @param parameters see {@link #parameters()}
     * @param textures see {@link #textures()}
     */
    public Material {
        parameters = List.copyOf(parameters);
        textures = List.copyOf(textures);
    }

    /**
     * A numeric parameter, for instance {@code Kd} with three values.
     *
     * @param key the name that the file gives it
     * @param values of which there is at least one in most files
     */
    public record Parameter(String key, float... values) {
        /**
         * Copies the values.
         *
         * @param key see {@link #key()}
         * @param values see {@link #values()}
         */
        public Parameter {
            values = values.clone();
        }

        /** {@return a copy of the values} */
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

    /**
     * A texture, by the path that the model file gives, for instance {@code map_Kd wood.png}.
     *
     * @param key the name that the file gives to the use of the texture
     * @param path of the image, relative to the model file
     */
    public record TextureReference(String key, String path) {}

    /**
     * Makes a material with a name and nothing else.
     *
     * @param name of the material
     * @return a material without parameters and textures
     */
    public static Material named(String name) {
        return new Material(name, List.of(), List.of());
    }

    /**
     * Finds a parameter.
     *
     * @param key the name that the file gives it
     * @return a copy of the values of the first parameter under that key, or null
     */
    public float[] parameter(String key) {
        for (Parameter p : parameters) {
            if (p.key.equals(key)) return p.values();
        }
        return null;
    }

    /** {@return red, green, blue, opacity (0..1) to draw with: base colour, diffuse colour or light grey} */
    public float[] displayColour() {
        float[] base = parameter("baseColorFactor");
        if (base != null && base.length == 4) return base;
        float[] rgb = parameter("Kd");
        if (rgb == null) rgb = parameter("rgb");
        if (rgb == null || rgb.length != 3) rgb = new float[] {.8f, .8f, .8f};
        float[] opacity = parameter("d");
        return new float[] {rgb[0], rgb[1], rgb[2], opacity == null || opacity.length != 1 ? 1f : opacity[0]};
    }

    /** {@return the path of the colour texture to draw with, or null} */
    public String displayTexture() {
        for (TextureReference t : textures) {
            if (t.key.equals("map_Kd") || t.key.equals("baseColorTexture")) return t.path;
        }
        return null;
    }
}
