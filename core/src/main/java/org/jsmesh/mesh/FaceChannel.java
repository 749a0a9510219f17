package org.jsmesh.mesh;

import java.util.List;

/**
 * One attribute of the faces of a mesh that is kept and not drawn by itself: a scalar by face, the name of a group or
 * an object, the smoothing group. It is no part of the shape, so it does not steer the simplification, and an archive
 * brings it at its end.
 *
 * <p>The raw values of face {@code f} are the {@link #words} ints of {@code values} from {@code f * words()} on, as in
 * {@link Channel}. Where there are labels, a value is the number of one of them. Arrays are shared, not copied.
 *
 * @param name the name in the file; unique within a mesh. {@link #OBJECT}, {@link #GROUP} and {@link #SMOOTHING} have a
 *     meaning
 * @param components values per face, 1 to 4
 * @param type how one component is stored; {@link Channel.Type#INT32} where there are labels
 * @param values raw values
 * @param labels the texts that values number from 0; empty when the values are numbers
 */
public record FaceChannel(String name, int components, Channel.Type type, int[] values, List<String> labels) {
    /** Name of the channel with the names of objects, as labels; faces without one have the empty label. */
    public static final String OBJECT = "object";

    /** Name of the channel with the names of groups, as labels; faces without one have the empty label. */
    public static final String GROUP = "group";

    /** Name of the channel with the smoothing group of each face as a whole number; 0: flat. */
    public static final String SMOOTHING = "smoothing";

    /**
     * Checks the values.
     *
     * @param name see {@link #name()}
     * @param components see {@link #components()}
     * @param type see {@link #type()}
     * @param values see {@link #values()}
     * @param labels see {@link #labels()}
     * @throws IllegalArgumentException when components is not 1 to 4, words does not divide the number of values, or a
     *     value is the number of no label
     */
    public FaceChannel {
        if (components < 1 || components > 4)
            throw new IllegalArgumentException("components of " + name + ": " + components);
        if (values.length % (components * type.words()) != 0)
            throw new IllegalArgumentException(values.length + " values for " + components + " components of " + name);
        labels = List.copyOf(labels);
        if (!labels.isEmpty()) {
            if (components != 1 || type != Channel.Type.INT32)
                throw new IllegalArgumentException("labels of " + name + " are not numbered by one INT32");
            for (int value : values)
                if (value < 0 || value >= labels.size())
                    throw new IllegalArgumentException("label " + value + " of " + labels.size() + " of " + name);
        }
    }

    /** {@return the same channel without values and labels, for no faces} */
    public FaceChannel kind() {
        return new FaceChannel(name, components, type, new int[0], List.of());
    }

    /** {@return ints per face: as many as components, twice as many for {@link Channel.Type#FLOAT64}} */
    public int words() {
        return components * type.words();
    }

    /** {@return the number of faces that the values are for} */
    public int faces() {
        return values.length / words();
    }

    /**
     * The value as it is stored.
     *
     * @param face id of the face
     * @param component 0 .. components − 1
     * @return the float or whole number, exactly
     */
    public double exact(int face, int component) {
        return type.number(values, (face * components + component) * type.words());
    }

    /**
     * The label of a face.
     *
     * @param face id of the face
     * @return the text
     * @throws IndexOutOfBoundsException when the channel has no labels
     */
    public String label(int face) {
        return labels.get(values[face]);
    }

    /**
     * The same channel with other values, for instance of other faces.
     *
     * @param newValues raw values; taken over, not copied
     * @return a channel that differs from this one in its values alone
     */
    public FaceChannel withValues(int[] newValues) {
        return new FaceChannel(name, components, type, newValues, labels);
    }
}
