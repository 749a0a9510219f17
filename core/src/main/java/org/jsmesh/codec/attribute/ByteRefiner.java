package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.SpreadCoder;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the low bits of 8-bit values that came with their wedge in units of 2<sup>shift</sup>: the place in the unit,
 * given the wedges around and the components before.
 */
public final class ByteRefiner implements ChannelRefiner {
    private static final double MEMORY = 16; // wedges
    private static final double LEAST_ERROR = .25;
    private final ChannelValues values;
    private final Channel original; // encoder only
    private final TwinCoder twins;
    private final SpreadCoder offsets;
    private final double[] usualError; // by component
    private double[] errors; // of the first component by wedge; negative: not known yet
    private WedgeRing ring;

    public ByteRefiner(ChannelValues values, Channel original) {
        this.values = values;
        this.original = original;
        twins = new TwinCoder(values, original);
        offsets = new SpreadCoder(values.components);
        usualError = new double[values.components];
    }

    @Override
    public void begin(LodMesh mesh, Translation translation, WedgeRing surroundings, WedgeTwins mirrored) {
        ring = surroundings;
        twins.begin(mesh, mirrored);
        errors = new double[mesh.wedges()];
        Arrays.fill(errors, -1);
        Arrays.fill(usualError, 1);
    }

    @Override
    public void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        if (twins.code(coder, wedge, originalWedge)) return;
        int bits = values.format.shift();
        boolean isForetold = ring.predict(wedge, values);
        int cellBefore = 0; // of the component before, and what the wedges around predicted for it
        double aroundBefore = 0;
        for (int k = 0; k < values.components; k++) {
            int wanted = coder.isEncoder() ? original.values()[values.components * originalWedge + k] : 0;
            int low = values.cell(wedge, k) >> bits << bits;
            double around = isForetold ? ring.predicted[k] : values.cell(wedge, k);
            boolean follows = values.format.follows() && k < ChannelCoder.FOLLOWING;
            double predicted = follows ? around + cellBefore - aroundBefore : around;
            double size = k == 0 ? ring.meanOf(errors, wedge, usualError[0]) : usualError[k];
            int cell =
                    low + offsets.code(coder, k, predicted - low + .5, Math.max(LEAST_ERROR, size), bits, wanted - low);
            values.set(wedge, k, cell, cell);
            cellBefore = cell;
            aroundBefore = around;
            double error = Math.abs(cell - predicted);
            usualError[k] += (error - usualError[k]) / MEMORY;
            if (k == 0) errors[wedge] = error;
        }
    }
}
