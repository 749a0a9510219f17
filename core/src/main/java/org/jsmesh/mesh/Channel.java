package org.jsmesh.mesh;

import java.util.BitSet;

/**
 * One attribute of the wedges of a mesh: {@code components} values per wedge, held as raw bits so that equality is
 * exact.
 *
 * <p>The values of wedge {@code w} are {@code values()[w * components] .. values()[w * components + components - 1]}:
 * float32 bits for {@link Type#FLOAT32}, 0..255 for {@link Type#UINT8}. A wedge may lack the attribute
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
        UINT8
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
     * @param values components × wedges raw values
     * @param absent wedges without this attribute, or null when every wedge has it
     * @throws IllegalArgumentException when components is not 1 to 4, or does not divide the number of values
     */
    public Channel(Semantic semantic, String name, int components, Type type, int[] values, BitSet absent) {
        if (components < 1 || components > 4)
            throw new IllegalArgumentException("components of " + name + ": " + components);
        if (values.length % components != 0)
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

    /** {@return values per wedge, 1 to 4} */
    public int components() {
        return components;
    }

    /** {@return how one component is stored} */
    public Type type() {
        return type;
    }

    /** {@return raw values, {@code components} per wedge: float32 bits or integers; shared, not copied} */
    public int[] values() {
        return values;
    }

    /** {@return the number of wedges that the values are for} */
    public int wedges() {
        return values.length / components;
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
     * The value as a number: the float, or the integer divided by 255.
     *
     * @param wedge id of the wedge
     * @param component 0 .. components − 1
     * @return the value of one component; in 0..1 for {@link Type#UINT8}
     */
    public float number(int wedge, int component) {
        int raw = values[wedge * components + component];
        // through bits: in JavaScript, nothing else rounds
        return Float.intBitsToFloat(type == Type.FLOAT32 ? raw : Float.floatToIntBits((float) (raw / 255.0)));
    }

    /**
     * The same channel with other values, for instance of fewer wedges.
     *
     * @param newValues components × wedges raw values; taken over, not copied
     * @param newAbsent wedges without the attribute, or null when every wedge has it
     * @return a channel that differs from this one in its values alone
     */
    public Channel withValues(int[] newValues, BitSet newAbsent) {
        return new Channel(semantic, name, components, type, newValues, newAbsent);
    }
}
