package org.jsmesh.codec;

import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/** Codes the rest of values that are known in units of 2<sup>shift</sup> cells: where in their unit they lie, given what the wedges around them foretell. */
final class StagedRefiner implements ChannelRefiner {
    private static final int KINDS = 3; // without a prediction, at the rim of a chart, inside of it
    private final ChannelValues values;
    private final Channel original; // encoder only
    private final OffsetCoder offsets;
    private final LatticeCoder[] points;
    private final int[] same = BinaryCoder.newContexts(2);
    private int lastSame;
    private WedgeRing ring;
    private TwinTable twins;

    StagedRefiner(ChannelValues values, Channel original) {
        this.values = values;
        this.original = original;
        offsets = new OffsetCoder(KINDS);
        points = new LatticeCoder[values.components];
        for (int k = 0; k < points.length; k++) points[k] = new LatticeCoder(values.format.lattice());
    }

    @Override
    public void begin(LodMesh mesh, Translation translation, WedgeRing surroundings) {
        ring = surroundings;
        twins = new TwinTable(values, mesh.wedges());
    }

    @Override
    public void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        int twin = twins.replace(wedge);
        if (twin >= 0 && codeSame(coder, wedge, twin, originalWedge)) return;
        int bits = values.format.shift();
        boolean foretold = ring.predict(wedge, values);
        int kind = !foretold ? 0 : ring.isOpen() ? 1 : 2;
        int most = 2 << bits;
        for (int k = 0; k < points.length; k++) {
            int raw = coder.isEncoder() ? original.values()[points.length * originalWedge + k] : 0;
            int wanted = coder.isEncoder() ? points[k].cell(raw) : 0;
            int low = values.cell(wedge, k) >> bits << bits;
            double off = foretold ? ring.predicted[k] - low : 1 << bits - 1;
            int expected = (int) Math.max(-most, Math.min(most, off));
            int cell = low + offsets.code(coder, kind, expected, bits, wanted - low);
            values.set(wedge, k, values.checked(cell), points[k].code(coder, cell, raw));
        }
    }

    /** Codes whether the values are those of the twin, and takes them. */
    private boolean codeSame(BinaryCoder coder, int wedge, int twin, int originalWedge) {
        int is = 1;
        for (int k = 0; k < points.length && coder.isEncoder(); k++)
            if (original.values()[points.length * originalWedge + k] != values.value(twin, k)) is = 0;
        lastSame = coder.bit(same, lastSame, is);
        if (lastSame == 0) return false;
        for (int k = 0; k < points.length; k++) values.set(wedge, k, values.cell(twin, k), values.value(twin, k));
        return true;
    }
}
