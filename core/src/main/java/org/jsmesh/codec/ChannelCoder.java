package org.jsmesh.codec;

import java.util.Arrays;
import java.util.BitSet;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/** Codes one attribute channel wedge by wedge: on its lattice, as the difference from a mean of known wedges. */
final class ChannelCoder {
    private static final int UINT8_LIMIT = 256;
    private final ChannelFormat format;
    private final Channel original; // encoder only
    private final int components;
    private final ResidualCoder residuals;
    private final LatticeCoder[] points;
    private final int[] absence = BinaryCoder.newContexts(2);
    private final BitSet absent = new BitSet();
    private int[] cells = new int[64];
    private int[] values = new int[64];
    private int lastAbsent;
    private final double[] sum = new double[4];
    private final double[] low = new double[4];
    private final double[] high = new double[4];
    private int terms;

    ChannelCoder(ChannelFormat format, Channel original) {
        this.format = format;
        this.original = original;
        components = format.components();
        residuals = new ResidualCoder(2 * components, 0);
        points = new LatticeCoder[components];
        for (int k = 0; k < components; k++)
            points[k] = format.lattice() == null ? null : new LatticeCoder(format.lattice());
    }

    /** Forgets the wedges that the next prediction is made of. */
    void beginPrediction() {
        terms = 0;
        Arrays.fill(sum, 0);
    }

    /** Adds a known wedge to the prediction. */
    void predictFrom(int wedge) {
        if (absent.get(wedge)) return;
        for (int k = 0; k < components; k++) {
            double x = cells[components * wedge + k];
            sum[k] += x;
            low[k] = terms == 0 || x < low[k] ? x : low[k];
            high[k] = terms == 0 || x > high[k] ? x : high[k];
        }
        terms++;
    }

    /** Codes the values of a new wedge. */
    void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        if (components * (wedge + 1) > cells.length) {
            int size = Math.max(components * (wedge + 1), 2 * cells.length);
            cells = Arrays.copyOf(cells, size);
            values = Arrays.copyOf(values, size);
        }
        boolean encoder = coder.isEncoder();
        if (format.hasAbsent()) {
            lastAbsent = coder.bit(absence, lastAbsent, encoder && original.isAbsent(originalWedge) ? 1 : 0);
            absent.set(wedge, lastAbsent != 0);
            if (lastAbsent != 0) return;
        }
        for (int k = 0; k < components; k++) {
            int at = components * wedge + k;
            int raw = encoder ? original.values()[components * originalWedge + k] : 0;
            int predicted = terms == 0 ? 0 : round(sum[k] / terms);
            int role = k + (terms == 0 ? components : 0);
            int size = terms == 0 ? 1 << 20 : (int) Math.min(1 << 28, 4 * (high[k] - low[k]) + 4);
            int wanted = !encoder ? 0 : points[k] == null ? raw : points[k].cell(raw);
            cells[at] = checked(predicted
                    + residuals.code(
                            coder, role, ResidualCoder.scale(size), ResidualCoder.NO_SURPRISE, 0, wanted - predicted));
            values[at] = points[k] == null ? cells[at] : points[k].code(coder, cells[at], raw);
        }
    }

    private int checked(int cell) throws MalformedStreamException {
        boolean outside = format.lattice() == null
                ? cell < 0 || cell >= UINT8_LIMIT
                : cell >= format.lattice().cellLimit()
                        || cell < -format.lattice().cellLimit();
        if (outside) throw new MalformedStreamException(-1, "a value of " + format.name() + " is out of range");
        return cell;
    }

    private static int round(double x) {
        return (int) (x < 0 ? x - .5 : x + .5);
    }

    /** The channel of the first {@code wedges} wedges. */
    Channel channel(int wedges) {
        return new Channel(
                format.semantic(),
                format.name(),
                components,
                format.type(),
                Arrays.copyOf(values, wedges * components),
                (BitSet) absent.clone());
    }
}
