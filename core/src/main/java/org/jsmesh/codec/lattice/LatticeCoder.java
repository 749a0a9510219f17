package org.jsmesh.codec.lattice;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes which of the lattice's points in a known cell is the value, so that cell and point give back the exact float32.
 * Values off the lattice are coded as one of the float32 numbers in the cell, or as raw bits. One instance per column
 * of values.
 */
public final class LatticeCoder {
    private static final int FINITE = 0x7f800000;
    private final Lattice lattice;
    private final int[] exception = BinaryCoder.newContexts(1);
    private final int[] within = BinaryCoder.newContexts(1);
    private final int[] zero = BinaryCoder.newContexts(1);
    private final int[] repeats = BinaryCoder.newContexts(2);
    private final IntegerModel decades = new IntegerModel(1);
    private final LatticePoint point = new LatticePoint();

    public LatticeCoder(Lattice lattice) {
        this.lattice = lattice;
    }

    /** The cell of a value: the encoder's side. */
    public int cell(int floatBits) {
        if (!find(floatBits)) return lattice.nearestCell(floatBits);
        int magnitude = 0;
        int below = lattice.gridExponent - point.exponent;
        if (below < 0) magnitude = point.mantissa * lattice.power(-below);
        else if (below <= lattice.digits) magnitude = point.mantissa / lattice.power(below);
        return floatBits < 0 ? -1 - magnitude : magnitude;
    }

    private boolean find(int floatBits) {
        return point.find(lattice.powers, lattice.digits, lattice.minExponent, floatBits);
    }

    /** Codes the value within its cell and returns its float32 bits. */
    public int code(BinaryCoder coder, int cell, int floatBits) throws MalformedStreamException {
        return code(coder, cell, floatBits, false, 0);
    }

    /**
     * Codes the value within its cell and returns its float32 bits.
     *
     * @param hasNeighbour whether a value near it in the mesh lies in the same cell; on planes across an axis it is
     *     often the very same
     */
    public int code(BinaryCoder coder, int cell, int floatBits, boolean hasNeighbour, int neighbourBits)
            throws MalformedStreamException {
        int magnitude = cell < 0 ? -1 - cell : cell;
        if (hasNeighbour && (magnitude == 0 || lattice.exponentIn(magnitude) < lattice.gridExponent)) {
            if (coder.bit(repeats, magnitude == 0 ? 0 : 1, floatBits == neighbourBits ? 1 : 0) != 0)
                return neighbourBits;
        }
        boolean found = !coder.isEncoder() || find(floatBits);
        if (lattice.hasExceptions && coder.bit(exception, 0, found ? 0 : 1) != 0) {
            return codeException(coder, cell, floatBits);
        }
        int bits = magnitude == 0 ? codeNearZero(coder) : codeWithin(coder, magnitude);
        if (bits >= FINITE) throw new MalformedStreamException(-1, "a value is beyond float32");
        return cell < 0 ? bits | 0x80000000 : bits;
    }

    /**
     * Codes which of the float32 numbers in its cell a value is, or all of its bits where rounding put it into a cell
     * beside.
     */
    private int codeException(BinaryCoder coder, int cell, int floatBits) throws MalformedStreamException {
        int magnitude = cell < 0 ? -1 - cell : cell;
        int sign = cell < 0 ? 0x80000000 : 0;
        int low = lattice.powers.bits(magnitude, lattice.gridExponent);
        int count = lattice.powers.bits(magnitude + 1, lattice.gridExponent) - low;
        int place = (floatBits ^ sign) - low;
        boolean isWithin = place >= 0 && place < count;
        if (count > 0 && coder.bit(within, 0, isWithin ? 1 : 0) != 0)
            return checked(low + coder.uniform(place, count)) | sign;
        return checked(coder.raw(floatBits, 32));
    }

    private static int checked(int bits) throws MalformedStreamException {
        if ((bits & FINITE) == FINITE) throw new MalformedStreamException(-1, "a value is not a finite number");
        return bits;
    }

    private int codeWithin(BinaryCoder coder, int magnitude) {
        int exponent = lattice.exponentIn(magnitude);
        int points = lattice.power(lattice.gridExponent - exponent);
        int place = coder.isEncoder() ? point.mantissa - magnitude * points : 0;
        if (points > 1) place = coder.uniform(place, points);
        return lattice.powers.bits(magnitude * points + place, exponent);
    }

    private int codeNearZero(BinaryCoder coder) throws MalformedStreamException {
        boolean encoder = coder.isEncoder();
        if (coder.bit(zero, 0, encoder && point.mantissa == 0 ? 1 : 0) != 0) return 0;
        int highest = lattice.gridExponent - lattice.digits;
        int exponent = lattice.minExponent;
        int floor = 1; // smallest and one more than the largest mantissa
        int ceiling = lattice.power(Math.min(lattice.digits, lattice.gridExponent - exponent));
        if (highest > exponent) {
            int down = decades.unsigned(coder, encoder ? highest - point.exponent : 0);
            if (down > highest - exponent) throw new MalformedStreamException(-1, "a value is below its lattice");
            exponent = highest - down;
            if (exponent > lattice.minExponent) floor = lattice.power(lattice.digits - 1);
        }
        if (ceiling <= floor) throw new MalformedStreamException(-1, "a cell of the lattice holds zero alone");
        int mantissa = floor + coder.uniform(encoder ? point.mantissa - floor : 0, ceiling - floor);
        return lattice.powers.bits(mantissa, exponent);
    }
}
