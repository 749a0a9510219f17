package org.jsmesh.results;

import java.util.Arrays;

/** Adds up the bits that a woven decoder reads, for each kind of what it is decoding. One decoder at a time. */
public final class BitLedger {
    /** What bits are for. Methods that decode one kind may call those of another. */
    enum Kind {
        OTHER,
        FLAGS,
        CUTS,
        STITCHES,
        TANGENTIAL,
        NORMAL,
        BASE,
        MOVED,
        SWEEPS,
        MIRROR,
        LATTICE,
        ATTRIBUTES
    }

    private static final double ONE = 1 << 15;
    private static final double[] BITS = new double[Kind.values().length];
    private static final int[] OPEN = new int[64]; // kinds of the methods that are running; 0 at first
    private static int depth;

    private BitLedger() {}

    /** Forgets all bits. */
    public static void clear() {
        Arrays.fill(BITS, 0);
        depth = 0;
    }

    /** Bits so far, by {@link Kind}. */
    public static double[] bits() {
        return BITS.clone();
    }

    /** A method begins that decodes a kind. */
    public static void enter(int kind) {
        OPEN[++depth] = kind;
    }

    /** It returns. */
    public static void leave() {
        depth--;
    }

    /** A bit was decoded, whose probability of being one was this part of 32768. */
    public static void bit(int value, int probability) {
        add(ONE / (value == 1 ? probability : ONE - probability));
    }

    /** So many bits were read as they are. */
    public static void raw(int count) {
        BITS[OPEN[depth]] += count;
    }

    /** One of so many equally probable values was decoded. */
    public static void below(int bound) {
        add(bound);
    }

    private static void add(double choices) {
        BITS[OPEN[depth]] += Math.log(choices) / Math.log(2);
    }
}
