package org.jsmesh.codec.position;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.RadixPowers;

/**
 * Finds the {@link Mirror} of a mesh: the plane across an axis that is in the middle of most pairs of vertices with two
 * equal coordinates. The encoder's side.
 */
public final class MirrorDetector {
    /** The share of the vertices that must have an image. */
    private static final double LEAST_SHARE = .1;

    /** Where more vertices have the same two coordinates, they lie on a line and say nothing. */
    private static final int MOST_ALIKE = 8;

    /** If there are more vertices, only those count whose other two coordinates are in one of eight classes. */
    private static final int MOST_WHOLE = 1 << 14;

    private final int[] bits; // x y z per vertex
    private final Lattice lattice;
    private final int classes; // a mask of hashes; vertices with none of its bits count

    private MirrorDetector(int[] bits, Lattice lattice) {
        this.bits = bits;
        this.lattice = lattice;
        classes = bits.length / 3 > MOST_WHOLE ? 7 : 0;
    }

    public static Mirror detect(int[] bits, Lattice lattice) {
        MirrorDetector detector = new MirrorDetector(bits, lattice);
        Mirror best = Mirror.NONE;
        int most = (int) (LEAST_SHARE / 2 * bits.length / 3 / (detector.classes + 1));
        for (int axis = 0; axis < 3; axis++) {
            for (Map.Entry<Integer, Integer> sum : detector.pairs(axis).entrySet()) {
                Mirror mirror = new Mirror(axis, sum.getKey());
                if (sum.getValue() <= most || !mirror.fits(lattice)) continue;
                most = sum.getValue();
                best = mirror;
            }
        }
        return best;
    }

    /** Number of pairs for each sum, by its float32 bits. */
    private Map<Integer, Integer> pairs(int axis) {
        int b = axis == 0 ? 1 : 0;
        int c = axis == 2 ? 1 : 2;
        long[] keys = new long[bits.length / 3];
        int n = 0;
        for (int v = 0; v < bits.length / 3; v++) {
            int hash = bits[3 * v + b] * 0x9e3779b1 + bits[3 * v + c] * 0x85ebca6b;
            hash ^= hash >>> 15;
            if ((hash & classes) == 0) keys[n++] = (long) hash << 32 | v;
        }
        keys = Arrays.copyOf(keys, n);
        Arrays.sort(keys);
        Map<Integer, Integer> pairs = new HashMap<>();
        int start = 0;
        for (int end = 1; end <= keys.length; end++) {
            if (end < keys.length && keys[end] >> 32 == keys[start] >> 32) continue;
            if (end - start <= MOST_ALIKE) count(keys, start, end, axis, b, c, pairs);
            start = end;
        }
        return pairs;
    }

    private void count(long[] keys, int start, int end, int axis, int b, int c, Map<Integer, Integer> pairs) {
        for (int i = start; i < end; i++) {
            int v = 3 * (int) keys[i];
            for (int j = start; j < i; j++) {
                int w = 3 * (int) keys[j];
                if (bits[v + b] != bits[w + b] || bits[v + c] != bits[w + c] || bits[v + axis] == bits[w + axis])
                    continue;
                double sum = (double) Float.intBitsToFloat(bits[v + axis]) + Float.intBitsToFloat(bits[w + axis]);
                pairs.merge(rounded(sum), 1, Integer::sum);
            }
        }
    }

    /** Sums of decimals are decimals, rounding aside. */
    private int rounded(double sum) {
        if (lattice.powers == RadixPowers.TWO) return Float.floatToIntBits((float) (sum + 0.0));
        double step = lattice.powers.number(1, lattice.minExponent);
        double units = Math.floor(sum / step + .5);
        return Float.floatToIntBits((float) (units * step + 0.0));
    }
}
