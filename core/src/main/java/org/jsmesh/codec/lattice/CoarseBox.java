package org.jsmesh.codec.lattice;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * A box around a mesh in units of 2<sup>shift</sup> cells of the positions' lattice, some dozen of them to its longest
 * side. It takes a few bytes and serves until the exact bounds have come.
 */
public final class CoarseBox {
    /** Bits of the longest side in units. */
    private static final int BITS = 5;

    private static final int MAX_BITS = 29;
    private static final int AXES = 3;

    /** Bits of the longest side in cells. */
    public final int extentBits;

    private final int shift;
    private final int[] low = new int[AXES];
    private final int[] size = new int[AXES];

    private CoarseBox(int extentBits) {
        this.extentBits = extentBits;
        shift = Math.max(0, extentBits - BITS);
    }

    /** @param bounds of the mesh: smallest x, y, z, largest x, y, z */
    public static CoarseBox of(float[] bounds, Lattice lattice, Translation translation) {
        double longest = 0;
        for (int a = 0; a < AXES; a++) longest = Math.max(longest, (double) bounds[a + AXES] - bounds[a]);
        CoarseBox box = new CoarseBox(
                IntegerLog.bits((int) Math.min(longest / translation.scale() / lattice.spacing(), Integer.MAX_VALUE)));
        double unit = lattice.spacing() * (1 << box.shift);
        for (int a = 0; a < AXES; a++) {
            double offset = translation.offset(a);
            box.low[a] = (int) Math.floor((bounds[a] - offset) / translation.scale() / unit);
            box.size[a] = (int) Math.floor((bounds[a + AXES] - offset) / translation.scale() / unit) + 1 - box.low[a];
        }
        return box;
    }

    /** Writes a box, or reads one when the coder is a decoder. */
    public static CoarseBox code(BinaryCoder coder, CoarseBox box) throws MalformedStreamException {
        boolean write = coder.isEncoder();
        CoarseBox coded = new CoarseBox(coder.raw(write ? box.extentBits : 0, BITS));
        IntegerModel numbers = new IntegerModel(1);
        for (int a = 0; a < AXES; a++) {
            coded.low[a] = numbers.signed(coder, 0, write ? box.low[a] : 0);
            coded.size[a] = coder.raw(write ? box.size[a] : 0, BITS + 1);
            double far = Math.abs((double) coded.low[a]) + coded.size[a];
            if (far * (1 << coded.shift) > 1 << MAX_BITS)
                throw new MalformedStreamException(-1, "the mesh lies beyond its lattice");
        }
        return coded;
    }

    /** The middle, in cells. */
    public int middle(int axis) {
        return (2 * low[axis] + size[axis]) * (1 << shift) / 2;
    }

    /** Half of the longest side, in cells. */
    public int halfSide() {
        return (Math.max(size[0], Math.max(size[1], size[2])) << shift) / 2;
    }

    /** The box as smallest x, y, z, largest x, y, z of what is shown. */
    public float[] bounds(Lattice lattice, Translation translation) {
        float[] bounds = new float[2 * AXES];
        double unit = lattice.spacing() * (1 << shift);
        for (int a = 0; a < AXES; a++) {
            bounds[a] = (float) (low[a] * unit * translation.scale() + translation.offset(a));
            bounds[a + AXES] = (float) ((low[a] + size[a]) * unit * translation.scale() + translation.offset(a));
        }
        return bounds;
    }
}
