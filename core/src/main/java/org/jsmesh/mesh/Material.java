package org.jsmesh.mesh;

import java.util.Arrays;
import java.util.List;

/**
 * The discrete attribute of a face (D of the paper): a name, and either numeric parameters or a definition of glTF,
 * with references to textures. Parameters and references have the keys of the file that they came from ({@code Kd},
 * {@code Ns}, {@code map_Kd} of MTL; {@code rgb} of Hoppe's .m; {@code baseColorTexture} of glTF). Equality is of raw
 * float bits and of texts; the order of parameters is kept and counts.
 *
 * <p>A definition of glTF is the material object of glTF 2.0 as JSON without blanks: all that the file has but the
 * name, with its order and the texts of its numbers. In place of its number each texture stands itself, with its
 * sampler in place of that one's number. A {@code source} is a position in {@code textures}:
 *
 * <pre>{@code
 * {"pbrMetallicRoughness":{"baseColorTexture":{"index":{"sampler":{"wrapS":33071},"source":0},"texCoord":1}}}
 * }</pre>
 *
 * @param name as the model file gives it; several materials may share one
 * @param parameters in the order of the file; none beside a definition of glTF
 * @param textures in the order of the file
 * @param gltf the definition of glTF; empty for materials of other formats
 */
public record Material(String name, List<Parameter> parameters, List<TextureReference> textures, String gltf) {
    /**
     * Copies the lists.
     *
     * @param name see {@link #name()}
     * @param parameters see {@link #parameters()}
     * @param textures see {@link #textures()}
     * @param gltf see {@link #gltf()}
     */
    public Material {
        parameters = List.copyOf(parameters);
        textures = List.copyOf(textures);
    }

    /**
     * Makes a material of another format than glTF.
     *
     * @param name see {@link #name()}
     * @param parameters see {@link #parameters()}
     * @param textures see {@link #textures()}
     */
    public Material(String name, List<Parameter> parameters, List<TextureReference> textures) {
        this(name, parameters, textures, "");
    }

    /** {@return whether the material is defined as glTF defines one} */
    public boolean isGltf() {
        return !gltf.isEmpty();
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
}
