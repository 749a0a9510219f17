package org.jsmesh.codec;

import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/** Codes the rest of values that are known in units of 2<sup>shift</sup> cells: where in their unit they lie, given what the wedges around them foretell. */
final class StagedRefiner implements ChannelRefiner {
    private final ChannelValues values;
    private final Channel original; // encoder only
    private final OffsetCoder offsets;
    private final LatticeCoder[] points;
    private WedgeRing ring;

    StagedRefiner(ChannelValues values, Channel original) {
        this.values = values;
        this.original = original;
        offsets = new OffsetCoder(2 * values.components);
        points = new LatticeCoder[values.components];
        for (int k = 0; k < points.length; k++) points[k] = new LatticeCoder(values.format.lattice());
    }

    @Override
    public void begin(LodMesh mesh, Translation translation, WedgeRing surroundings) {
        ring = surroundings;
    }

    @Override
    public void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        int bits = values.format.shift();
        boolean foretold = ring.predict(wedge, values);
        int most = 2 << bits;
        for (int k = 0; k < points.length; k++) {
            int raw = coder.isEncoder() ? original.values()[points.length * originalWedge + k] : 0;
            int wanted = coder.isEncoder() ? points[k].cell(raw) : 0;
            int low = values.cell(wedge, k) >> bits << bits;
            double off = foretold ? ring.predicted[k] - low : 1 << bits - 1;
            int expected = (int) Math.max(-most, Math.min(most, off));
            int cell = low + offsets.code(coder, foretold ? k : k + points.length, expected, bits, wanted - low);
            values.set(wedge, k, values.checked(cell), points[k].code(coder, cell, raw));
        }
    }
}
