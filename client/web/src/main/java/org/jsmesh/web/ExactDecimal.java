package org.jsmesh.web;

import java.util.Arrays;

/**
 * Writes a double as the decimal number that it is: an integer, and a power of ten. The shortest digits that mean the
 * same double would need tables that are a tenth of the page's decoder.
 */
final class ExactDecimal {
    private static final int LIMB = 1_000_000_000;
    private static final int LIMB_DIGITS = 9;

    private ExactDecimal() {}

    /** @param value finite */
    static void append(StringBuilder out, double value) {
        long bits = Double.doubleToRawLongBits(value);
        int exponent = Math.max((int) (bits >>> 52) & 2047, 1);
        long mantissa = (bits & (1L << 52) - 1) + ((bits >>> 52 & 2047) == 0 ? 0 : 1L << 52);
        int zeros = Math.min(Long.numberOfTrailingZeros(mantissa), 52);
        int twos = exponent - 1075 + zeros; // the value is mantissa · 2^twos
        mantissa >>= zeros;
        // An integer from its lowest limb on. A negative power of 2 is one of 5 over one of 10.
        int[] limbs = {(int) (mantissa % LIMB), (int) (mantissa / LIMB)};
        for (int i = 0; i < Math.abs(twos); i++) limbs = times(limbs, twos > 0 ? 2 : 5);
        if (bits < 0) out.append('-');
        int last = limbs.length - 1;
        while (last > 0 && limbs[last] == 0) last--;
        out.append(limbs[last]);
        while (--last >= 0) {
            String digits = String.valueOf(limbs[last]);
            for (int i = digits.length(); i < LIMB_DIGITS; i++) out.append('0');
            out.append(digits);
        }
        if (twos < 0) out.append("e").append(twos);
    }

    private static int[] times(int[] limbs, int factor) {
        int carry = 0;
        for (int i = 0; i < limbs.length; i++) {
            long product = (long) limbs[i] * factor + carry;
            limbs[i] = (int) (product % LIMB);
            carry = (int) (product / LIMB);
        }
        if (carry == 0) return limbs;
        int[] longer = Arrays.copyOf(limbs, limbs.length + 1);
        longer[limbs.length] = carry;
        return longer;
    }
}
