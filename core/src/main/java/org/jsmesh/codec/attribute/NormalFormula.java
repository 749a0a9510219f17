package org.jsmesh.codec.attribute;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Mesh;

/**
 * How normals are computed from the faces that share a wedge: the weights of their normals, and whether the sum is made
 * a unit vector. Many tools leave such normals in their files; these normals hold nothing new.
 *
 * @param weight one of {@link #AREA}, {@link #UNIFORM}, {@link #ANGLE}
 */
public record NormalFormula(int weight, boolean isUnit) {
    static final int AREA = 0;
    static final int UNIFORM = 1;
    static final int ANGLE = 2;
    private static final int WEIGHTS = 3;
    private static final int PROBES = 4000;

    /** Differences below this fraction of a length are no worse than others: they are rounding. */
    private static final double ROUNDING = 1e-8;

    public static NormalFormula code(BinaryCoder coder, NormalFormula formula) throws MalformedStreamException {
        boolean write = coder.isEncoder();
        int weight = coder.raw(write ? formula.weight : 0, 2);
        if (weight >= WEIGHTS) throw new MalformedStreamException(-1, "normals of the unknown kind " + weight);
        return new NormalFormula(weight, coder.raw(write && formula.isUnit ? 1 : 0, 1) != 0);
    }

    /** The formula whose normals are closest to those of a channel. */
    static NormalFormula closest(Mesh mesh, Channel normals) {
        NormalFormula best = null;
        double least = 0;
        for (int weight = 0; weight < WEIGHTS; weight++) {
            NormalSums sums = new NormalSums(weight, mesh.wedges());
            for (int f = 0; f < mesh.faces(); f++) sums.addFace(mesh, f);
            for (int unit = 1; unit >= 0; unit--) {
                double bits = difference(sums, unit != 0, normals);
                if (best == null || bits < least) {
                    best = new NormalFormula(weight, unit != 0);
                    least = bits;
                }
            }
        }
        return best;
    }

    /** Sum of the binary logarithms of differences between computed and given components. */
    private static double difference(NormalSums sums, boolean unit, Channel normals) {
        int step = 1 + normals.wedges() / PROBES;
        double bits = 0;
        for (int w = 0; w < normals.wedges(); w += step) {
            if (normals.isAbsent(w)) continue;
            double scale = unit ? sums.unitScale(w) : 1;
            double length = ROUNDING;
            double off = 0;
            for (int k = 0; k < 3; k++) {
                double x = normals.number(w, k);
                length += x < 0 ? -x : x;
                double difference = x - scale * sums.component(w, k);
                off += difference < 0 ? -difference : difference;
            }
            bits += IntegerLog.log8((int) (1 + Math.min(off / length / ROUNDING, 1 << 30)));
        }
        return bits;
    }
}
