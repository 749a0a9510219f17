package org.jsmesh.codec.attribute;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.ResidualCoder;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.codec.lattice.StepCoder;
import org.jsmesh.codec.lattice.Translation;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.WedgeTwins;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes exact normals when the exact mesh is there, as differences from the normals that their faces give, from the
 * mean of the neighbours or from the mirror image. The two components across the predicted direction come first; a unit
 * vector's third follows from them.
 */
public final class NormalRefiner implements ChannelRefiner {
    private static final int ROLES = 6; // three of images

    private static final int FRACTION = 4; // parts of a cell in expected sizes
    private static final int UNIT = ResidualCoder.scale(FRACTION); // scale class of one cell
    private final ChannelValues values;
    private final NormalFormula formula;
    private final Lattice lattice;
    private final double spacing;
    private final Channel original; // encoder only
    private final ResidualCoder residuals = new ResidualCoder(ROLES, UNIT);
    private final LatticeCoder[] points = new LatticeCoder[3];
    private final double[] predicted = new double[3];
    private final StepCoder steps;
    private final double[] mean = new double[3];
    private final int[] interpolated = BinaryCoder.newContexts(2);
    private int lastInterpolated;
    private NormalSums sums;
    private WedgeRing ring;
    private WedgeTwins twins;
    private final int[] imaged = BinaryCoder.newContexts(2);
    private int lastImaged;

    public NormalRefiner(ChannelValues values, Channel original) {
        this.values = values;
        this.original = original;
        formula = values.format.normals();
        lattice = values.format.lattice();
        spacing = lattice.spacing();
        steps = new StepCoder(lattice, ROLES);
        for (int k = 0; k < 3; k++) points[k] = new LatticeCoder(lattice);
    }

    @Override
    public void begin(LodMesh mesh, Translation translation, WedgeRing surroundings, WedgeTwins images) {
        twins = images;
        sums = NormalSums.of(mesh, formula.weight(), translation);
        ring = surroundings;
    }

    @Override
    public void code(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        double scale = formula.isUnit() ? sums.unitScale(wedge) : 1;
        double length = 0;
        for (int k = 0; k < 3; k++) predicted[k] = scale * sums.component(wedge, k);
        boolean isImage = codeImage(coder, wedge, originalWedge);
        boolean isMean = !isImage && codeMean(coder, wedge, originalWedge);
        int role = isImage ? 3 : 0;
        for (int k = 0; k < 3; k++) length += Math.abs(predicted[k]);
        int last = largest();
        int first = last == 0 ? 1 : 0;
        int second = last == 2 ? 1 : 2;
        double expected = length * FRACTION * Math.sqrt(sums.disagreement(wedge)) / spacing;
        int size = 1 + (int) Math.min(1 << 28, expected);
        int wrong = codeComponent(coder, role, first, size, wedge, originalWedge);
        wrong += codeComponent(coder, role + 1, second, Math.min(1 << 28, size + wrong >> 1), wedge, originalWedge);
        if (wrong > 0 && formula.isUnit() && !isMean && !isImage) predictLast(last, wedge, first, second);
        codeComponent(coder, role + 2, last, Math.min(1 << 28, 1 + wrong), wedge, originalWedge);
    }

    /**
     * Codes whether the mean of the neighbours' normals is closer, where there is one. If it is, it becomes the
     * prediction.
     */
    private boolean codeMean(BinaryCoder coder, int wedge, int originalWedge) {
        if (!ring.interpolate(wedge, values, mean)) return false;
        lastInterpolated = coder.bit(interpolated, lastInterpolated, isBetter(coder, originalWedge) ? 1 : 0);
        if (lastInterpolated == 0) return false;
        System.arraycopy(mean, 0, predicted, 0, 3);
        return true;
    }

    /** Is the mean closer? The encoder's side. */
    private boolean isBetter(BinaryCoder coder, int originalWedge) {
        double better = 0;
        for (int k = 0; k < 3 && coder.isEncoder(); k++) {
            double x = Float.intBitsToFloat(original.values()[3 * originalWedge + k]);
            better = better + Math.abs(x - predicted[k]) - Math.abs(x - mean[k]);
        }
        return better > 0;
    }

    /**
     * Codes whether the image of the mirror image's normal is closer, where there is one. If it is, it becomes the
     * prediction.
     */
    private boolean codeImage(BinaryCoder coder, int wedge, int originalWedge) {
        int twin = twins == null ? -1 : twins.of(wedge);
        if (twin < 0 || !values.refined.get(twin) || values.absent.get(twin)) return false;
        for (int k = 0; k < 3; k++) {
            double x = Float.intBitsToFloat(values.value(twin, k));
            mean[k] = k == twins.mirror.axis() ? -x : x;
        }
        lastImaged = coder.bit(imaged, lastImaged, isBetter(coder, originalWedge) ? 1 : 0);
        if (lastImaged == 0) return false;
        System.arraycopy(mean, 0, predicted, 0, 3);
        return true;
    }

    private int largest() {
        double x = Math.abs(predicted[0]);
        double y = Math.abs(predicted[1]);
        double z = Math.abs(predicted[2]);
        return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    }

    /** The third component of a unit vector. */
    private void predictLast(int last, int wedge, int first, int second) {
        double x = Float.intBitsToFloat(values.value(wedge, first));
        double y = Float.intBitsToFloat(values.value(wedge, second));
        double square = 1 - x * x - y * y;
        double z = square > 0 ? Math.sqrt(square) : 0;
        predicted[last] = predicted[last] < 0 ? -z : z;
    }

    /** Returns the error of the prediction, in parts of cells. */
    private int codeComponent(BinaryCoder coder, int role, int k, int size, int wedge, int originalWedge)
            throws MalformedStreamException {
        int raw = coder.isEncoder() ? original.values()[3 * originalWedge + k] : 0;
        int bits = lattice.closest(predicted[k]);
        int near = points[k].cell(bits);
        if (steps.code(coder, role, bits, raw)) {
            if ((steps.reached() & 0x7f800000) == 0x7f800000)
                throw new MalformedStreamException(-1, "a value of " + values.format.name() + " is beyond float32");
            values.set(wedge, k, near, steps.reached());
            return Math.abs(steps.steps());
        }
        int wanted = coder.isEncoder() ? points[k].cell(raw) : 0;
        int residual =
                residuals.code(coder, role, ResidualCoder.scale(size), ResidualCoder.NO_SURPRISE, 0, wanted - near);
        int cell = values.checked(near + residual);
        values.set(wedge, k, cell, points[k].code(coder, cell, raw));
        int off = residual < 0 ? -residual : residual;
        return (1 + Math.min(off, 1 << 26)) * FRACTION;
    }
}
