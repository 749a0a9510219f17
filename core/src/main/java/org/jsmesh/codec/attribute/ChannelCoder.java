package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.ResidualCoder;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes one attribute channel wedge by wedge: in units of its lattice, as the difference from a mean of known wedges.
 */
public final class ChannelCoder {
    /** Red, green and blue, not the opacity behind them. */
    static final int FOLLOWING = 3;

    private final ChannelFormat format;
    private final ChannelValues values;
    private final Channel original; // encoder only
    private final int components;
    private final ResidualCoder residuals;
    private final LatticeCoder[] points;
    private final int[] absence = BinaryCoder.newContexts(2);
    private int lastAbsent;
    private final double[] sum = new double[4];
    private final double[] low = new double[4];
    private final double[] high = new double[4];
    private int terms;

    public ChannelCoder(ChannelValues values, Channel original) {
        this.values = values;
        format = values.format;
        this.original = original;
        components = format.components();
        residuals = new ResidualCoder(2 * components, 0);
        points = new LatticeCoder[components];
        for (int k = 0; k < components; k++)
            points[k] = format.lattice() == null ? null : new LatticeCoder(format.lattice());
    }

    /** Starts the next prediction, from no wedges. */
    void beginPrediction() {
        terms = 0;
        Arrays.fill(sum, 0);
    }

    /** Adds a known wedge to the prediction. */
    void predictFrom(int wedge) {
        if (format.normals() != null || values.absent.get(wedge)) return;
        for (int k = 0; k < components; k++) {
            double x = values.cell(wedge, k);
            sum[k] += x;
            low[k] = terms == 0 || x < low[k] ? x : low[k];
            high[k] = terms == 0 || x > high[k] ? x : high[k];
        }
        terms++;
    }

    /** Codes the values of a new wedge. */
    void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        values.grow(wedge);
        boolean encoder = coder.isEncoder();
        if (format.hasAbsent()) {
            lastAbsent = coder.bit(absence, lastAbsent, encoder && original.isAbsent(originalWedge) ? 1 : 0);
            values.absent.set(wedge, lastAbsent != 0);
            if (lastAbsent != 0) return;
        }
        if (format.normals() != null) return;
        int shift = format.shift();
        int before = 0; // difference of the component before from its mean
        for (int k = 0; k < components; k++) {
            int raw = encoder ? original.values()[components * originalWedge + k] : 0;
            int mean = (terms == 0 ? 0 : round(sum[k] / terms)) >> shift;
            int predicted = mean;
            if (format.follows() && k < FOLLOWING) predicted = Math.max(0, Math.min(255 >> shift, mean + before));
            int role = k + (terms == 0 ? components : 0);
            int size = terms == 0 ? 1 << 20 : (int) Math.min(1 << 28, 4 * (high[k] - low[k]) + 4);
            int wanted = !encoder ? 0 : (points[k] == null ? raw : points[k].cell(raw)) >> shift;
            int unit = predicted
                    + residuals.code(
                            coder,
                            role,
                            ResidualCoder.scale(size >> shift),
                            ResidualCoder.NO_SURPRISE,
                            0,
                            wanted - predicted);
            before = unit - mean;
            if (shift > 0) {
                values.setUnit(wedge, k, unit);
            } else {
                int cell = values.checked(unit);
                values.set(wedge, k, cell, points[k] == null ? cell : points[k].code(coder, cell, raw));
            }
        }
    }

    private static int round(double x) {
        return (int) (x < 0 ? x - .5 : x + .5);
    }
}
