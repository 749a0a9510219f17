package org.jsmesh.codec.attribute;

import java.util.BitSet;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeDetector;
import org.jsmesh.codec.lattice.RadixPowers;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.Mesh;

/** Finds how a channel is best coded: the encoder's side of {@link ChannelFormat}. */
public final class ChannelDetector {
    /** Bits of the first stage of floating-point attributes. */
    private static final int COARSE_BITS = 8;

    /** The same of 8-bit colours. */
    private static final int COARSE_BYTE_BITS = 5;

    /** Fewer bits are not worth a stage of their own. */
    private static final int LEAST_SHIFT = 2;

    /** Decimals of flipped texture coordinates, and the share of the values that must have them. */
    private static final int LEAST_DIGITS = 3;

    private static final int MOST_DIGITS = 7;
    private static final double USUAL = .9;

    private ChannelDetector() {}

    /** @param previewSide pixels of the longer side of the largest preview, or 0 */
    public static ChannelFormat detect(Mesh mesh, Channel c, int previewSide) {
        if (c.type() == Channel.Type.UINT8) return format(c, null, byteShift(c), follows(mesh, c), false, null);
        Channel flipped = flipped(c);
        boolean flips = flipped != null
                && LatticeDetector.bits(flipped.values()) < LatticeDetector.bits(c.values()) - c.values().length;
        Channel coded = flips ? flipped : c;
        Lattice lattice = LatticeDetector.detect(coded.values());
        if (ChannelFormat.areNormals(c.semantic(), c.components()))
            return format(c, lattice, 0, false, false, NormalFormula.closest(mesh, c));
        return format(c, lattice, shift(lattice, coded, previewSide), false, flips, null);
    }

    private static ChannelFormat format(
            Channel c, Lattice lattice, int shift, boolean follows, boolean flips, NormalFormula normals) {
        return new ChannelFormat(
                c.semantic(),
                c.name(),
                c.components(),
                c.type(),
                lattice,
                c.hasAbsent(),
                shift,
                follows,
                flips,
                normals);
    }

    /** The channel with the values that are coded. */
    public static Channel coded(ChannelFormat format, Channel original) {
        return format.isFlipped() ? flipped(original) : original;
    }

    private static BitSet absent(Channel channel) {
        BitSet absent = new BitSet();
        for (int w = 0; w < channel.wedges(); w++) if (channel.isAbsent(w)) absent.set(w);
        return absent;
    }

    /**
     * Texture coordinates with the second component subtracted from 1, as decimals where these give the same value.
     * Null when the subtraction cannot be undone, or decimals are rare.
     */
    private static Channel flipped(Channel c) {
        if (c.semantic() != Channel.Semantic.TEXCOORD || c.components() != 2) return null;
        int fewest = (int) (USUAL * c.wedges());
        Channel best = null;
        for (RadixPowers powers : new RadixPowers[] {RadixPowers.TEN, RadixPowers.ROUNDED_TEN}) {
            for (int digits = LEAST_DIGITS; digits <= MOST_DIGITS; digits++) {
                int[] values = c.values().clone();
                int decimals = flip(c, powers, digits, values);
                if (decimals < 0) return null;
                if (decimals <= fewest) continue;
                fewest = decimals;
                best = c.withValues(values, absent(c));
                break;
            }
        }
        return best;
    }

    /** Turns the second components; the number of those that are decimals, or −1 when not all can be turned back. */
    private static int flip(Channel c, RadixPowers powers, int digits, int[] values) {
        int decimals = 0;
        for (int w = 0; w < c.wedges(); w++) {
            if (c.isAbsent(w)) continue;
            int shown = c.values()[2 * w + 1];
            int decimal = decimal(1 - (double) c.number(w, 1), powers, digits);
            boolean fits = ChannelFormat.flipped(decimal) == shown;
            if (fits) decimals++;
            values[2 * w + 1] = fits ? decimal : ChannelFormat.flipped(shown);
            if (ChannelFormat.flipped(values[2 * w + 1]) != shown) return -1;
        }
        return decimals;
    }

    /** The float32 bits of a number rounded to so many decimals. */
    private static int decimal(double number, RadixPowers powers, int digits) {
        int units = (int) Math.floor(RadixPowers.TEN.number(1, digits) * Math.abs(number) + .5);
        int bits = powers.bits(units, -digits);
        return number < 0 && units > 0 ? bits | 0x80000000 : bits;
    }

    /** Bytes of other channels than colours may be names of things, with nothing between them. */
    private static int byteShift(Channel channel) {
        if (channel.semantic() != Channel.Semantic.COLOUR) return 0;
        int low = 255;
        int high = 0;
        for (int x : channel.values()) {
            low = Math.min(low, x);
            high = Math.max(high, x);
        }
        int shift = IntegerLog.bits(high - low) - COARSE_BYTE_BITS;
        return shift < LEAST_SHIFT ? 0 : shift;
    }

    /**
     * Leaves {@link #COARSE_BITS} of the values' range to their first stage, and none of values that nobody sees.
     * Texture coordinates are as fine as half a pixel of a preview, so that it is not shown in the wrong place.
     */
    private static int shift(Lattice lattice, Channel channel, int previewSide) {
        double low = 0;
        double high = 0;
        for (int i = 0; i < channel.values().length; i++) {
            double x = channel.number(i / channel.components(), i % channel.components());
            low = i == 0 || x < low ? x : low;
            high = i == 0 || x > high ? x : high;
        }
        // what is off the lattice may be further out, and has the last cell
        int cells = (int) Math.min((high - low) / lattice.spacing(), 2.0 * lattice.cellLimit());
        boolean isShown = channel.semantic() != Channel.Semantic.CUSTOM;
        int kept = isShown ? COARSE_BITS : 0;
        if (channel.semantic() == Channel.Semantic.TEXCOORD) kept = Math.max(kept, IntegerLog.bits(previewSide));
        int shift = IntegerLog.bits(cells) - kept;
        return shift < LEAST_SHIFT ? 0 : shift;
    }

    /** Do red, green and blue rather change together than each by itself? */
    private static boolean follows(Mesh mesh, Channel c) {
        if (c.components() < ChannelCoder.FOLLOWING) return false;
        long alone = 0;
        long together = 0;
        int[] corners = mesh.faceWedges();
        for (int i = 1; i < corners.length; i++) {
            int a = corners[i - 1] * c.components();
            int b = corners[i] * c.components();
            int before = c.values()[a] - c.values()[b];
            for (int k = 1; k < ChannelCoder.FOLLOWING; k++) {
                int change = c.values()[a + k] - c.values()[b + k];
                alone += Math.abs(change);
                together += Math.abs(change - before);
                before = change;
            }
        }
        return together < alone;
    }
}
