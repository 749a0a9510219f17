package org.jsmesh.codec.attribute;

import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.mesh.Channel;

/**
 * How a channel is coded.
 *
 * @param lattice of its values; null for 8-bit integers
 * @param hasAbsent whether wedges may lack it
 * @param shift values come with their wedge in units of 2^shift cells, and exactly in an {@link AttributeSweep}; 0:
 *     exactly at once
 * @param follows whether the second and third component change with the one before, as the components of grey do
 * @param isFlipped whether the second component is coded as its difference from 1: texture coordinates that were turned
 *     over after they had been decimal text
 * @param normals how the values are predicted; normals come in an {@link AttributeSweep} alone. Null when they are not
 *     normals
 */
public record ChannelFormat(
        Channel.Semantic semantic,
        String name,
        int components,
        Channel.Type type,
        Lattice lattice,
        boolean hasAbsent,
        int shift,
        boolean follows,
        boolean isFlipped,
        NormalFormula normals) {

    /** Does an {@link AttributeSweep} bring values? */
    public boolean isRefined() {
        return shift > 0 || normals != null;
    }

    /** Are channels of float32 values with this meaning normals that faces may give? */
    public static boolean areNormals(Channel.Semantic semantic, int components) {
        return semantic == Channel.Semantic.NORMAL && components == 3;
    }

    /** The difference of a value from 1; both raw float32 bits. */
    static int flipped(int bits) {
        return Float.floatToIntBits((float) (1 - (double) Float.intBitsToFloat(bits)));
    }

    /** Coded values as they are shown. */
    int[] turned(int[] values) {
        if (!isFlipped) return values;
        int[] turned = values.clone();
        for (int i = 1; i < values.length; i += components) turned[i] = flipped(values[i]);
        return turned;
    }
}
