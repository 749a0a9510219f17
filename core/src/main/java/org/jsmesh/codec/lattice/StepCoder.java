package org.jsmesh.codec.lattice;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;

/**
 * Codes a value that differs from its prediction by hardly more than rounding, as the number of lattice points between
 * them.
 */
public final class StepCoder {
    private static final int MOST_STEPS = 31;
    private static final int FAR = MOST_STEPS + 1;
    private final Lattice lattice;
    private final int[] far;
    private final IntegerModel steps;
    private final LatticePoint point = new LatticePoint();
    private int last;
    private int lastSteps;
    private int reached;

    public StepCoder(Lattice lattice, int roles) {
        this.lattice = lattice;
        far = BinaryCoder.newContexts(3 * roles);
        steps = new IntegerModel(4 * roles);
    }

    /**
     * Codes a value if it is close, and says whether it was.
     *
     * @param near float32 bits of the prediction, a point of the lattice
     * @param wanted float32 bits, for the encoder
     */
    public boolean code(BinaryCoder coder, int role, int near, int wanted) {
        boolean found = find(near);
        double from = found ? lattice.index(point.mantissa, point.exponent) : 0;
        int distance = FAR;
        if (coder.isEncoder() && found && (near ^ wanted) >= 0 && find(wanted)) {
            double difference = lattice.index(point.mantissa, point.exponent) - from;
            if (Math.abs(difference) <= MOST_STEPS) distance = (int) difference;
        }
        int context = 3 * role + (last >= FAR ? 2 : last > 0 ? 1 : 0);
        boolean isFar = coder.bit(far, context, distance == FAR ? 1 : 0) != 0;
        if (isFar) {
            last = FAR;
            return false;
        }
        int coded = steps.signed(coder, 4 * role + Math.min(last, 3), distance);
        distance = Math.max(-MOST_STEPS, Math.min(MOST_STEPS, coded)); // more in damaged streams
        last = Math.abs(distance);
        lastSteps = distance;
        reached = lattice.bitsAt(Math.max(0, from + distance)) | near & 0x80000000;
        return true;
    }

    /** Can a value be coded in this way? The encoder's side. */
    public boolean reaches(int near, int wanted) {
        if ((near ^ wanted) < 0 || !find(near)) return false;
        double from = lattice.index(point.mantissa, point.exponent);
        return find(wanted) && Math.abs(lattice.index(point.mantissa, point.exponent) - from) <= MOST_STEPS;
    }

    private boolean find(int bits) {
        return point.find(lattice.powers, lattice.digits, lattice.minExponent, bits);
    }

    /** Number of steps between the last value and its prediction. */
    public int steps() {
        return lastSteps;
    }

    /** The value last coded, as float32 bits. */
    public int reached() {
        return reached;
    }
}
