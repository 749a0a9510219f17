package org.jsmesh.encode.write;

import org.jsmesh.archive.coding.IndexCoder;
import org.jsmesh.codec.MeshFormat;

/**
 * Decides how precise positions are at each level of detail. It keeps their unit in proportion to the error that
 * simplification alone leaves. A unit is a cell of the lattice times 2<sup>shift</sup>.
 */
final class PrecisionSchedule {
    /**
     * A unit is at most this many times the mean error that the level would have with exact positions: about the least
     * error for the bytes.
     */
    private static final double UNITS_PER_ERROR = 4;

    /** The same where the picture counts for more than the bytes. */
    private static final double FINE_UNITS_PER_ERROR = 1.2;

    /** The same of the error at the end of a stage, in which places are chosen with the precision in view. */
    private static final double UNITS_OF_STAGE = 6;

    private static final int FEWEST_BITS = 4;

    /** Least shift of a unit that is worth a sweep of its own before the exact positions. */
    private static final int FINEST_SHIFT = 2;

    /** Bits that are enough for the eye; they are sent before what only the exact copy needs. */
    private static final int DISPLAY_BITS = 14;

    private double unitsPerError = UNITS_PER_ERROR;
    private final int extentBits;
    private final double cellPercent; // of the diagonal

    /** @param bounds of the original: smallest x, y, z, largest x, y, z */
    PrecisionSchedule(MeshFormat format, float[] bounds) {
        extentBits = format.extentBits();
        double squares = 0;
        for (int a = 0; a < 3; a++) {
            double side = (double) bounds[a + 3] - bounds[a];
            squares += side * side;
        }
        cellPercent = squares > 0 ? format.cellSize() * 100 / Math.sqrt(squares) : 0;
    }

    /** Makes levels more precise than is best for the bytes. */
    void showFinely() {
        unitsPerError = FINE_UNITS_PER_ERROR;
    }

    /** A length in cells, in % of the diagonal. */
    double percent(double cells) {
        return cells * cellPercent;
    }

    /** The largest shift that makes sense. */
    int coarsest() {
        return Math.max(0, extentBits - FEWEST_BITS);
    }

    /**
     * The shift for a level with an expected mean error in % of the diagonal. It does not exceed the shift
     * {@code before}.
     */
    int of(double errorPercent, int before) {
        int shift = before;
        while (shift > Math.max(FINEST_SHIFT, extentBits - DISPLAY_BITS)
                && cellPercent * (1 << shift) > unitsPerError * errorPercent) shift--;
        return shift < FINEST_SHIFT ? 0 : shift;
    }

    /** The shift for a stage at whose end levels have a mean error of so many cells. */
    int ofStage(double cells) {
        return of(percent(cells) * UNITS_OF_STAGE / UNITS_PER_ERROR, coarsest());
    }

    /** True when no level asks for more than this shift. */
    boolean isFinest(int shift) {
        return shift <= Math.max(FINEST_SHIFT, extentBits - DISPLAY_BITS);
    }

    /** The sweeps after the last pass. */
    int[] last(int shift) {
        if (shift == 0) return new int[0];
        int display = extentBits - DISPLAY_BITS;
        return display < shift && display >= FINEST_SHIFT ? new int[] {display, 0} : new int[] {0};
    }

    /** Bits of the longest side to which positions are known when the coarsest have this shift. */
    int bits(int shift) {
        return IndexCoder.precision(extentBits, shift);
    }

    /** The largest shift of positions that are known to so many bits. */
    int shift(int bits) {
        return Math.max(0, extentBits - bits);
    }
}
