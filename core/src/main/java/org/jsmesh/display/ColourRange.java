package org.jsmesh.display;

import org.jsmesh.mesh.Channel;

/**
 * The number that stands for full light in a channel of colours. Small integers have the largest one of their type.
 * Other numbers tell it: whole ones beyond 1 go up to 255, or to 65,535. Fractions beyond 1 are light of more than the
 * full one, up to a limit; beyond that they are means of whole numbers.
 */
public final class ColourRange {
    private static final int[] WHOLE = {1, 255, 65535};
    /** No file has light of more than this. */
    private static final double BRIGHTEST = 16;

    private double largest;
    private boolean isWhole = true;

    ColourRange() {}

    /**
     * The value that is drawn as full light, for numbers as {@link Channel#number} gives them.
     *
     * @param colour a channel of colours
     * @return 1, 255, 65,535, or the largest number of 32 bits for integers beyond that
     */
    public static double full(Channel colour) {
        ColourRange range = new ColourRange();
        for (int w = 0; w < colour.wedges(); w++) if (!colour.isAbsent(w)) range.add(colour, w);
        return range.full(colour.type());
    }

    /** Does the type alone tell full light? */
    static boolean isKnown(Channel.Type type) {
        return !type.isFloat() && type != Channel.Type.INT32 && type != Channel.Type.UINT32;
    }

    void add(Channel colour, int wedge) {
        for (int k = 0; k < colour.components(); k++) {
            double value = colour.number(wedge, k);
            if (value != Math.floor(value)) isWhole = false;
            if (value > largest) largest = value;
        }
    }

    /** Full light of the colours that were added. */
    double full(Channel.Type type) {
        if (!isWhole && largest <= BRIGHTEST) return 1;
        for (int full : WHOLE) if (largest <= full) return full;
        return type.isFloat() ? 1 : type == Channel.Type.INT32 ? 2147483647.0 : 4294967295.0;
    }
}
