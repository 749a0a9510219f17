package org.jsmesh.codec;

/**
 * The move that a mesh made after its coordinates had been decimal text: x = fl32(t + o) with t on a lattice and an offset o per axis. Tools that centre models leave such
 * coordinates. Coding t instead of x saves the noise that the rounding of the sum left in the last bits.
 */
final class Translation {
    static final Translation NONE = new Translation(new int[3]);

    /** Raw float32 bits per axis. */
    final int[] offsets;

    Translation(int[] offsets) {
        this.offsets = offsets;
    }

    boolean isNone() {
        return (offsets[0] | offsets[1] | offsets[2]) == 0;
    }

    /** What is added along an axis. */
    double offset(int axis) {
        return Float.intBitsToFloat(offsets[axis]);
    }

    /** The coordinate x that a value t stands for; both raw float32 bits. Finite: what is beyond float32 becomes its largest number. */
    int moved(int axis, int bits) {
        if (offsets[axis] == 0) return bits;
        double sum = (double) Float.intBitsToFloat(bits) + Float.intBitsToFloat(offsets[axis]);
        int moved = Float.floatToIntBits((float) sum);
        return (moved & 0x7fffffff) < 0x7f800000 ? moved : moved & 0x80000000 | 0x7f7fffff;
    }
}
