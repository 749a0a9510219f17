package org.jsmesh.codec.position;

import org.jsmesh.codec.lattice.Lattice;

/**
 * The plane across an axis that mirrors most of a symmetric model: x + x' = sum. Values are those of the lattice,
 * before their translation.
 *
 * @param sum float32 bits
 */
public record Mirror(int axis, int sum) {
    public static final Mirror NONE = new Mirror(-1, 0);

    public boolean isNone() {
        return axis < 0;
    }

    /** Does every cell have an image that is a cell? */
    boolean isExact() {
        return (sum & 0x7fffffff) == 0;
    }

    /** The image of a cell. */
    int cell(int cell, Lattice lattice) {
        return (int) Math.floor(Float.intBitsToFloat(sum) / lattice.spacing() - cell - .5);
    }

    /** The float32 bits of the image of an exact value. */
    int bits(int bits, Lattice lattice) {
        if (isExact()) return bits ^ 0x80000000;
        return lattice.closest((double) Float.intBitsToFloat(sum) - Float.intBitsToFloat(bits));
    }

    /** Do the images of a lattice's cells fit an int? */
    public boolean fits(Lattice lattice) {
        double cells = Float.intBitsToFloat(sum) / lattice.spacing();
        return cells > -4.0 * lattice.cellLimit() && cells < 4.0 * lattice.cellLimit();
    }
}
