package org.jsmesh.codec.lattice;

/**
 * The move that a mesh made after its coordinates had been decimal text: x = fl32(t + o) with t on a lattice and an
 * offset o per axis, or x = fl32(t · f) with a factor f. Tools that centre models, or change their units, leave such
 * coordinates. Coding t instead of x saves the noise that the rounding left in the last bits.
 */
public final class Translation {
    private static final int ONE = 0x3f800000;
    public static final Translation NONE = new Translation(new int[3]);

    /** Raw float32 bits per axis. */
    public final int[] offsets;

    /** Raw float32 bits. */
    public final int factor;

    public Translation(int[] offsets) {
        this(offsets, ONE);
    }

    private Translation(int[] offsets, int factor) {
        this.offsets = offsets;
        this.factor = factor;
    }

    public static Translation scaled(int factor) {
        return new Translation(new int[3], factor);
    }

    public boolean isNone() {
        return (offsets[0] | offsets[1] | offsets[2]) == 0 && !isScaled();
    }

    public boolean isScaled() {
        return factor != ONE;
    }

    /** The factor that values are multiplied by. */
    public double scale() {
        return Float.intBitsToFloat(factor);
    }

    /** The offset along an axis. */
    public double offset(int axis) {
        return Float.intBitsToFloat(offsets[axis]);
    }

    /**
     * The coordinate x of a value t; both are raw float32 bits. The result is finite: beyond float32 it is the largest
     * float32 number.
     */
    public int moved(int axis, int bits) {
        if (isScaled()) return finite((double) Float.intBitsToFloat(bits) * Float.intBitsToFloat(factor));
        if (offsets[axis] == 0) return bits;
        return finite((double) Float.intBitsToFloat(bits) + Float.intBitsToFloat(offsets[axis]));
    }

    private static int finite(double x) {
        int moved = Float.floatToIntBits((float) x);
        return (moved & 0x7fffffff) < 0x7f800000 ? moved : moved & 0x80000000 | 0x7f7fffff;
    }
}
