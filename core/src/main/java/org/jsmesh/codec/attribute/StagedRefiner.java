package org.jsmesh.codec.attribute;

import java.util.Arrays;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.entropy.SpreadCoder;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the rest of values that are known in units of 2<sup>shift</sup> cells: the place in the unit, given what the
 * wedges around, or the mirror image, predict.
 */
public final class StagedRefiner implements ChannelRefiner {
    private static final int NOTHING = 0; // kinds of predictions
    private static final int RIM = 1; // of a chart
    private static final int INSIDE = 2;
    private static final int IMAGE = 3;
    private static final int KINDS = 4;
    private static final double CHOICE_MEMORY = 8; // wedges
    private static final double MEMORY = 16;
    private static final double LEAST_ERROR = .25; // cells
    private final ChannelValues values;
    private final Channel original; // encoder only
    private final TwinCoder twins;
    private final SpreadCoder offsets = new SpreadCoder(KINDS);
    private final LatticeCoder[] points;
    private final double[] predicted;
    private final double[] usualError = new double[KINDS]; // of the last wedges, in cells
    private double aroundError; // of the predictions by the wedges around, of images: in bits
    private double imageError;
    private double[] errors; // per wedge in cells; negative: not known yet
    private WedgeRing ring;
    private TwinMap map; // null where there is no mirror, or values are no pairs

    public StagedRefiner(ChannelValues values, Channel original) {
        this.values = values;
        this.original = original;
        twins = new TwinCoder(values, original);
        points = new LatticeCoder[values.components];
        predicted = new double[values.components];
        for (int k = 0; k < points.length; k++) points[k] = new LatticeCoder(values.format.lattice());
    }

    @Override
    public void begin(LodMesh mesh, Translation translation, WedgeRing surroundings, WedgeTwins mirrored) {
        ring = surroundings;
        map = mirrored == null || values.components != 2 ? null : new TwinMap(mesh, mirrored, values);
        twins.begin(mesh, mirrored);
        errors = new double[mesh.wedges()];
        Arrays.fill(errors, -1);
        Arrays.fill(usualError, (1 << values.format.shift()) / 8.0);
    }

    @Override
    public void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        if (twins.code(coder, wedge, originalWedge)) return;
        int bits = values.format.shift();
        boolean isForetold = ring.predict(wedge, values);
        boolean hasImage = map != null && map.predict(wedge, ring.corner(wedge), usualError[IMAGE]);
        int kind = !isForetold ? NOTHING : ring.isOpen() ? RIM : INSIDE;
        if (hasImage && (!isForetold || imageError <= aroundError)) kind = IMAGE;
        predict(wedge, kind);
        double size = Math.max(LEAST_ERROR, ring.meanOf(errors, wedge, usualError[kind]));
        double sum = 0;
        for (int k = 0; k < points.length; k++) {
            int raw = coder.isEncoder() ? original.values()[points.length * originalWedge + k] : 0;
            int wanted = coder.isEncoder() ? points[k].cell(raw) : 0;
            int low = values.cell(wedge, k) >> bits << bits;
            int cell = low + offsets.code(coder, kind, predicted[k] - low + .5, size, bits, wanted - low);
            values.set(wedge, k, values.checked(cell), points[k].code(coder, cell, raw));
            sum += Math.abs(cell - predicted[k]);
            if (k == 0) size = Math.max(LEAST_ERROR, (size + sum) / 2);
        }
        errors[wedge] = sum / points.length;
        usualError[kind] += (errors[wedge] - usualError[kind]) / MEMORY;
        if (hasImage) compare(wedge, isForetold);
    }

    private void predict(int wedge, int kind) {
        for (int k = 0; k < points.length; k++) {
            if (kind == IMAGE) predicted[k] = map.predicted[k];
            else predicted[k] = kind == NOTHING ? values.cell(wedge, k) : ring.predicted[k];
        }
    }

    /** Learns which of the two predicts better here. */
    private void compare(int wedge, boolean isForetold) {
        double image = 0;
        double around = 0;
        for (int k = 0; k < points.length; k++) {
            int cell = values.cell(wedge, k);
            image += bits(cell - map.predicted[k]);
            around += isForetold ? bits(cell - ring.predicted[k]) : values.format.shift();
        }
        imageError += (image - imageError) / CHOICE_MEMORY;
        aroundError += (around - aroundError) / CHOICE_MEMORY;
    }

    private static int bits(double difference) {
        return IntegerLog.bits((int) Math.min(Math.abs(difference), 1 << 28));
    }
}
