package org.jsmesh.codec.attribute;

import java.util.Arrays;
import java.util.BitSet;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Sizes;

/**
 * The values of one attribute channel as far as they are known: per wedge its cells on the lattice and the raw values
 * that are shown.
 */
public final class ChannelValues {
    private static final int UINT8_LIMIT = 256;
    public final ChannelFormat format;
    final int components;
    final BitSet absent = new BitSet();

    /** The wedges that an {@link AttributeSweep} has made exact; for channels that it brings. */
    final BitSet refined = new BitSet();

    private int[] cells = new int[64];
    private int[] values = new int[64];

    public ChannelValues(ChannelFormat format) {
        this.format = format;
        components = format.components();
    }

    /** Makes room for a wedge. */
    void grow(int wedge) {
        if (components * (wedge + 1L) <= cells.length) return;
        int least = Sizes.of(components, wedge + 1L, "corners with " + format.name());
        int size = (int) Math.max(least, Math.min(Sizes.MOST, 2L * cells.length));
        cells = Arrays.copyOf(cells, size);
        values = Arrays.copyOf(values, size);
    }

    int cell(int wedge, int component) {
        return cells[components * wedge + component];
    }

    int value(int wedge, int component) {
        return values[components * wedge + component];
    }

    void set(int wedge, int component, int cell, int value) {
        cells[components * wedge + component] = cell;
        values[components * wedge + component] = value;
    }

    /** Sets a value that comes coarse first to the middle of its unit. */
    void setUnit(int wedge, int component, int unit) throws MalformedStreamException {
        int shift = format.shift();
        boolean bytes = format.lattice() == null;
        int limit = bytes ? UINT8_LIMIT : format.lattice().cellLimit();
        int low = unit << shift;
        if (low >> shift != unit || low >= limit || low + (1 << shift) <= (bytes ? 0 : -limit))
            throw new MalformedStreamException(-1, "a value of " + format.name() + " is out of range");
        int cell = low + (1 << shift - 1);
        set(
                wedge,
                component,
                cell,
                bytes ? shownByte(unit, shift) : format.lattice().shownBits(cell));
    }

    /** Spreads the units over all bytes, so that black, white and opaque values are shown as such. */
    private static int shownByte(int unit, int shift) {
        int last = UINT8_LIMIT - 1;
        return unit * last / (last >> shift);
    }

    int checked(int cell) throws MalformedStreamException {
        boolean outside = format.lattice() == null
                ? cell < 0 || cell >= UINT8_LIMIT
                : cell >= format.lattice().cellLimit()
                        || cell < -format.lattice().cellLimit();
        if (outside) throw new MalformedStreamException(-1, "a value of " + format.name() + " is out of range");
        return cell;
    }

    /** Whether a wedge lacks the attribute. */
    public boolean isAbsent(int wedge) {
        return absent.get(wedge);
    }

    /** Whether a wedge's normals are still to come. */
    public boolean isToCome(int wedge) {
        return format.normals() != null && !refined.get(wedge);
    }

    /** Copies the values of a wedge as they are shown. */
    public void copy(int wedge, int[] to) {
        System.arraycopy(values, components * wedge, to, 0, components);
        if (format.isFlipped()) to[1] = ChannelFormat.flipped(to[1]);
    }

    /** The channel of the first {@code wedges} wedges. */
    public Channel channel(int wedges) {
        grow(wedges);
        int[] shown = format.turned(Arrays.copyOf(values, wedges * components));
        if (format.isFlipped())
            for (int w = absent.nextSetBit(0); w >= 0 && w < wedges; w = absent.nextSetBit(w + 1))
                shown[components * w + 1] = 0;
        return new Channel(format.semantic(), format.name(), components, format.type(), shown, (BitSet) absent.clone());
    }
}
