package org.jsmesh.mesh;

import java.util.BitSet;

/**
 * One attribute of the wedges of a mesh: {@code components} values per wedge, held as raw bits so that equality is
 * exact.
 *
 * <p>The raw values of wedge {@code w} are the {@link #words} ints of {@code values()} from {@code w * words()} on: one
 * per component, two (low, then high bits) for {@link Type#FLOAT64}. A wedge may lack the attribute
 * ({@link #isAbsent}); its values are then 0. Arrays are shared, not copied; a channel is not modified once it is in a
 * mesh.
 */
public final class Channel {
    /** What a channel means to a viewer. */
    public enum Semantic {
        /** Unit vectors that lighting needs, three components. */
        NORMAL,
        /** Coordinates in a texture, usually two components. */
        TEXCOORD,
        /** Red, green, blue and perhaps opacity. */
        COLOUR,
        /** Anything else; it is kept and not drawn. */
        CUSTOM
    }

    /** How one component is stored. */
    public enum Type {
        /** The bits of an IEEE 754 number of 32 bits. */
        FLOAT32,
        /** A whole number from 0 to 255. */
        UINT8,
        /** A whole number from −128 to 127. */
        INT8,
        /** A whole number from −32,768 to 32,767. */
        INT16,
        /** A whole number from 0 to 65,535. */
        UINT16,
        /** A whole number of 32 bits. */
        INT32,
        /** A whole number from 0 to 2³² − 1, as the 32 bits that it has. */
        UINT32,
        /** The bits of an IEEE 754 number of 64 bits in two ints, the low ones first. */
        FLOAT64;

        /** {@return ints that hold one component: 2 for {@link #FLOAT64}, else 1} */
        public int words() {
            return this == FLOAT64 ? 2 : 1;
        }

        /** {@return true for floating-point numbers} */
        public boolean isFloat() {
            return this == FLOAT32 || this == FLOAT64;
        }

        /**
         * Reads a component.
         *
         * @param values raw values
         * @param at index of the component's first int
         * @return the number that the bits stand for, exactly
         */
        double number(int[] values, int at) {
            return switch (this) {
                case FLOAT32 -> Float.intBitsToFloat(values[at]);
                case FLOAT64 -> Double.longBitsToDouble((long) values[at + 1] << 32 | values[at] & 0xffffffffL);
                case UINT32 -> values[at] < 0 ? values[at] + 4294967296.0 : values[at];
                default -> values[at];
            };
        }

        /** Largest number of the type, for values that stand for a part of 1; 0 for floats and for 32 bits. */
        private double unit() {
            return switch (this) {
                case UINT8 -> 255;
                case INT8 -> 127;
                case UINT16 -> 65535;
                case INT16 -> 32767;
                default -> 0;
            };
        }
    }

    private final Semantic semantic;
    private final String name;
    private final int components;
    private final Type type;
    private final int[] values;
    private final BitSet absent;

    /**
     * Makes a channel that holds the given arrays, not copies of them.
     *
     * @param semantic what the channel means to a viewer
     * @param name the name in the file, for example {@code normal}, {@code uv}, {@code colour}; unique within a mesh
     * @param components values per wedge, 1 to 4
     * @param type how one component is stored
     * @param values raw values, {@link #words} ints per wedge
     * @param absent wedges without this attribute, or null when every wedge has it
     * @throws IllegalArgumentException when components is not 1 to 4, or words does not divide the number of values
     */
    public Channel(Semantic semantic, String name, int components, Type type, int[] values, BitSet absent) {
        if (components < 1 || components > 4)
            throw new IllegalArgumentException("components of " + name + ": " + components);
        if (values.length % (components * type.words()) != 0)
            throw new IllegalArgumentException(values.length + " values for " + components + " components of " + name);
        this.semantic = semantic;
        this.name = name;
        this.components = components;
        this.type = type;
        this.values = values;
        this.absent = absent == null || absent.isEmpty() ? null : absent;
    }

    /** {@return what the channel means to a viewer} */
    public Semantic semantic() {
        return semantic;
    }

    /** {@return the name in the file, unique within a mesh} */
    public String name() {
        return name;
    }

    /**
     * Whether colours are in linear light, as those that glTF calls {@code COLOR_0} and so on; others are values of a
     * screen (sRGB).
     *
     * @return false for channels that are no colours, too
     */
    public boolean isLinearLight() {
        return semantic == Semantic.COLOUR && name.startsWith("COLOR_");
    }

    /** {@return values per wedge, 1 to 4} */
    public int components() {
        return components;
    }

    /** {@return how one component is stored} */
    public Type type() {
        return type;
    }

    /** {@return raw values, {@link #words} per wedge; shared, not copied} */
    public int[] values() {
        return values;
    }

    /** {@return ints per wedge: as many as components, twice as many for {@link Type#FLOAT64}} */
    public int words() {
        return components * type.words();
    }

    /** {@return the number of wedges that the values are for} */
    public int wedges() {
        return values.length / words();
    }

    /**
     * Tells whether a wedge lacks this attribute; its values are then 0.
     *
     * @param wedge id of the wedge
     * @return true when it has none
     */
    public boolean isAbsent(int wedge) {
        return absent != null && absent.get(wedge);
    }

    /** {@return true when at least one wedge lacks this attribute} */
    public boolean hasAbsent() {
        return absent != null;
    }

    /**
     * The value as a viewer takes it: floats and whole numbers of 32 bits as they are, smaller whole numbers of
     * normals, texture coordinates and colours divided by the largest of their type.
     *
     * @param wedge id of the wedge
     * @param component 0 .. components − 1
     * @return the value of one component, rounded to float32
     */
    public float number(int wedge, int component) {
        double unit = semantic == Semantic.CUSTOM ? 0 : type.unit();
        if (unit == 0 && type == Type.FLOAT32) return Float.intBitsToFloat(values[wedge * components + component]);
        double exact = exact(wedge, component);
        // through bits: in JavaScript, nothing else rounds
        return Float.intBitsToFloat(Float.floatToIntBits((float) (unit == 0 ? exact : exact / unit)));
    }

    /**
     * The value as it is stored.
     *
     * @param wedge id of the wedge
     * @param component 0 .. components − 1
     * @return the float or whole number, exactly
     */
    public double exact(int wedge, int component) {
        return type.number(values, (wedge * components + component) * type.words());
    }

    /**
     * The same channel with other values, for instance of fewer wedges.
     *
     * @param newValues raw values, {@link #words} ints per wedge; taken over, not copied
     * @param newAbsent wedges without the attribute, or null when every wedge has it
     * @return a channel that differs from this one in its values alone
     */
    public Channel withValues(int[] newValues, BitSet newAbsent) {
        return new Channel(semantic, name, components, type, newValues, newAbsent);
    }
}
