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
        NORMAL,
        TEXCOORD,
        COLOUR,
        CUSTOM
    }

    /** How one component is stored. */
    public enum Type {
        FLOAT32,
        UINT8
    }

    private final Semantic semantic;
    private final String name;
    private final int components;
    private final Type type;
    private final int[] values;
    private final BitSet absent;

    /**
     * @param name the name in the file, for example {@code normal}, {@code uv}, {@code colour}; unique within a mesh
     * @param components values per wedge, 1 to 4
     * @param values components × wedges raw values
     * @param absent wedges without this attribute, or null when every wedge has it
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

    public Semantic semantic() {
        return semantic;
    }

    public String name() {
        return name;
    }

    public int components() {
        return components;
    }

    public Type type() {
        return type;
    }

    /** Raw values, {@code components} per wedge: float32 bits or integers. Shared. */
    public int[] values() {
        return values;
    }

    public int wedges() {
        return values.length / components;
    }

    public boolean isAbsent(int wedge) {
        return absent != null && absent.get(wedge);
    }

    public boolean hasAbsent() {
        return absent != null;
    }

    /** The value as a number: the float, or the integer divided by 255. */
    public float number(int wedge, int component) {
        int raw = values[wedge * components + component];
        // through bits: in JavaScript, nothing else rounds
        return Float.intBitsToFloat(type == Type.FLOAT32 ? raw : Float.floatToIntBits((float) (raw / 255.0)));
    }

    /** The same channel with other values, for instance of fewer wedges. */
    public Channel withValues(int[] newValues, BitSet newAbsent) {
        return new Channel(semantic, name, components, type, newValues, newAbsent);
    }
}
