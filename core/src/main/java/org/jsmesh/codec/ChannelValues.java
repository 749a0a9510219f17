package org.jsmesh.codec;

import java.util.Arrays;
import java.util.BitSet;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.MalformedStreamException;

/** The values of one attribute channel as far as they are known: per wedge its cells on the lattice and the raw values that are shown. */
final class ChannelValues {
    private static final int UINT8_LIMIT = 256;
    final ChannelFormat format;
    final int components;
    final BitSet absent = new BitSet();

    /** Exact values begin to count in the last sweep: wedges below this have them. Channels without one have only exact values. */
    private int refined;

    private int[] cells = new int[64];
    private int[] values = new int[64];

    ChannelValues(ChannelFormat format) {
        this.format = format;
        components = format.components();
    }

    /** Makes room for a wedge. */
    void grow(int wedge) {
        if (components * (wedge + 1) <= cells.length) return;
        int size = Math.max(components * (wedge + 1), 2 * cells.length);
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

    /** The wedges in front of this one have their exact values. */
    void refinedTo(int wedge) {
        refined = wedge;
    }

    int refined() {
        return refined;
    }

    /** The cell in the middle of a unit of values that come coarse first. */
    int middle(int unit) throws MalformedStreamException {
        int shift = format.shift();
        int limit = format.lattice().cellLimit();
        int low = unit << shift;
        if (low >> shift != unit || low >= limit || low + (1 << shift) <= -limit)
            throw new MalformedStreamException(-1, "a value of " + format.name() + " is out of range");
        return low + (1 << shift - 1);
    }

    int checked(int cell) throws MalformedStreamException {
        boolean outside = format.lattice() == null
                ? cell < 0 || cell >= UINT8_LIMIT
                : cell >= format.lattice().cellLimit()
                        || cell < -format.lattice().cellLimit();
        if (outside) throw new MalformedStreamException(-1, "a value of " + format.name() + " is out of range");
        return cell;
    }

    /** The channel of the first {@code wedges} wedges. */
    Channel channel(int wedges) {
        grow(wedges);
        return new Channel(
                format.semantic(),
                format.name(),
                components,
                format.type(),
                Arrays.copyOf(values, wedges * components),
                (BitSet) absent.clone());
    }
}
