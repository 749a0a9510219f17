package org.jsmesh.codec.lattice;

/**
 * Finds the scale of coordinates that were decimal text before a tool multiplied them, as changes of units and scene
 * nodes do. It looks for a factor of a list and a number of digits such that every coordinate is the factor times a
 * decimal.
 */
public final class ScaleDetector {
    private static final float[] FACTORS = {.01f, .001f, .1f, .0254f, .3048f, 10f, 100f, 1000f, 2.54f};
    private static final RadixPowers[] TRIED = {RadixPowers.TEN, RadixPowers.ROUNDED_TEN};
    private static final int LEAST_DIGITS = 3;

    /** One more would be about as many as float32 has, and anything would fit. */
    private static final int MOST_DIGITS = 6;

    /** So few coordinates may fit by chance. */
    private static final int LEAST_VALUES = 100;

    private final int[] bits;
    private final int[] undone;

    private ScaleDetector(int[] bits) {
        this.bits = bits;
        undone = new int[bits.length];
    }

    /**
     * Finds the factor and undoes the multiplication.
     *
     * @param bits raw float32 bits of coordinates; receives those before the multiplication
     * @return {@link Translation#NONE} when no factor explains every coordinate
     */
    public static Translation undo(int[] bits) {
        if (bits.length < LEAST_VALUES) return Translation.NONE;
        ScaleDetector detector = new ScaleDetector(bits);
        for (float factor : FACTORS) {
            for (RadixPowers powers : TRIED) {
                if (!detector.find(factor, powers)) continue;
                System.arraycopy(detector.undone, 0, bits, 0, bits.length);
                return Translation.scaled(Float.floatToIntBits(factor));
            }
        }
        return Translation.NONE;
    }

    private boolean find(float factor, RadixPowers powers) {
        for (int digits = LEAST_DIGITS; digits <= MOST_DIGITS; digits++)
            if (undoAll(factor, powers, digits)) return true;
        return false;
    }

    private boolean undoAll(float factor, RadixPowers powers, int digits) {
        Translation scale = Translation.scaled(Float.floatToIntBits(factor));
        for (int i = 0; i < bits.length; i++) {
            undone[i] = decimal(Math.abs((double) Float.intBitsToFloat(bits[i])) / factor, powers, digits)
                    | bits[i] & 0x80000000;
            if (scale.moved(0, undone[i]) != bits[i]) return false;
        }
        return true;
    }

    /** The float32 bits of a number rounded to so many digits. */
    private static int decimal(double number, RadixPowers powers, int digits) {
        if (number == 0) return 0;
        int exponent = -digits;
        for (double x = number; x >= 1; x /= 10) exponent++;
        for (double x = number; x < .1; x *= 10) exponent--;
        return powers.bits((int) (RadixPowers.TEN.scaled(number, exponent) + .5), exponent);
    }
}
