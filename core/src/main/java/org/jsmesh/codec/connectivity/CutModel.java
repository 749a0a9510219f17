package org.jsmesh.codec.connectivity;

import org.jsmesh.codec.entropy.BinaryCoder;

/**
 * How likely the run of faces that a new vertex takes begins at an edge, or grows by one. The logarithm of the odds is
 * a sum of small tables, one for each feature (an additive model, Hastie and Tibshirani 1986). The sum picks a context,
 * which starts at these odds and adapts.
 */
final class CutModel {
    private static final int RANKS = 4;
    private static final int SIDES = 2;
    private static final int LENGTHS = 8;
    private static final int VALENCES = 6;

    /** Numbers of {@link #edge}. */
    private static final int EDGES = 16 * LENGTHS * VALENCES;

    private static final int MOST_SLOTS = 12;
    private static final int COUNTS = 8;
    private static final int PARTS = 64; // contexts of a level, by what is to be coded
    private static final int LEVELS = 64;
    private static final int STEP = 3; // of the sum, from a level to the next
    private static final double FACTOR = 1.4549914146182013; // of the odds: exp(STEP / 8)
    private static final double HALF_FACTOR = 1.2062302494; // its root
    private static final int FIRST_COUNT = 6;
    private static final byte[] SEED = new byte[RANKS * EDGES]; // sums over the features of one edge
    private static final byte[] BEFORE_SEED = new byte[RANKS * EDGES];
    private static final byte[] BEHIND_SEED = new byte[RANKS * EDGES];
    private static final byte[] GROWN = new byte[SIDES * EDGES];
    private static final byte[] BEYOND = new byte[SIDES * EDGES];
    private static final byte[] OTHER_END = new byte[SIDES * EDGES];
    private static final int[] FIRST = new int[LEVELS];

    static {
        for (int shape = 0; shape < 16; shape++)
            for (int length = 0; length < LENGTHS; length++)
                for (int valence = 0; valence < VALENCES; valence++) addUp(shape, length, valence);
        for (int level = 0; level < LEVELS; level++) FIRST[level] = first(level);
    }

    private final int[] seeds = contexts();
    private final int[] growths = contexts();

    private static void addUp(int shape, int length, int valence) {
        int edge = edge(4 * shape, length, valence + 3);
        for (int rank = 0; rank < RANKS; rank++) {
            int at = rank * EDGES + edge;
            int size = rank * LENGTHS + length;
            SEED[at] = (byte)
                    (CutTables.seed(1, rank * 16 + shape) + CutTables.seed(2, size) + CutTables.seed(5, valence));
            BEFORE_SEED[at] = (byte) (CutTables.seed(3, size) + CutTables.seed(6, valence));
            BEHIND_SEED[at] = (byte) (CutTables.seed(4, size) + CutTables.seed(7, valence));
        }
        for (int side = 0; side < SIDES; side++) {
            int at = side * EDGES + edge;
            GROWN[at] = growth(1, side, shape, length, valence);
            BEYOND[at] = growth(2, side, shape, length, valence);
            OTHER_END[at] = growth(3, side, shape, length, valence);
        }
    }

    /** The sum over shape, length and valence of an edge in one of three roles. */
    private static byte growth(int role, int side, int shape, int length, int valence) {
        return (byte) (CutTables.growth(role, side * 16 + shape)
                + CutTables.growth(role + 3, side * LENGTHS + length)
                + CutTables.growth(role + 6, side * VALENCES + valence));
    }

    /** The context that a level starts with. */
    private static int first(int level) {
        int steps = level < LEVELS / 2 ? LEVELS / 2 - 1 - level : level - LEVELS / 2;
        double odds = HALF_FACTOR;
        for (int i = 0; i < steps; i++) odds *= FACTOR;
        double part = (level < LEVELS / 2 ? 1 : odds) / (1 + odds);
        return BinaryCoder.context((int) (part * 65536), FIRST_COUNT);
    }

    private static int[] contexts() {
        int[] contexts = new int[PARTS * LEVELS];
        for (int i = 0; i < contexts.length; i += LEVELS) System.arraycopy(FIRST, 0, contexts, i, LEVELS);
        return contexts;
    }

    /**
     * What the model knows of an edge.
     *
     * @param shape 0 to 63: its length against that of the diagonal that would replace it
     * @param length 0 to 7: its length against that of the others
     * @param valence of its other end
     */
    static int edge(int shape, int length, int valence) {
        return ((shape >> 2) * LENGTHS + length) * VALENCES + Math.max(0, Math.min(VALENCES - 1, valence - 3));
    }

    /**
     * Codes whether the run begins at an edge.
     *
     * @param rank edges that were tried before
     * @param left candidates that are left
     * @param gap 0 to 15: how much more likely the edge looks than the next candidate
     * @param before the edge in the slot before
     * @param behind the edge in the slot behind
     */
    int codeSeed(BinaryCoder coder, int rank, int left, int slots, int gap, int edge, int before, int behind, int bit) {
        int r = Math.min(rank, RANKS - 1);
        int sum = CutTables.seed(0, r * 16 + gap)
                + SEED[r * EDGES + edge]
                + BEFORE_SEED[r * EDGES + before]
                + BEHIND_SEED[r * EDGES + behind]
                + CutTables.seed(8, Math.min(15, left))
                + CutTables.seed(9, Math.min(slots, MOST_SLOTS));
        int part = Math.min(rank, 7) * 8 + Math.min(7, left);
        return coder.bit(seeds, part * LEVELS + level(sum), bit);
    }

    /**
     * Codes whether the run grows by an edge.
     *
     * @param count faces in the run
     * @param kind 0 to 7, of what is known of the run
     * @param beyond the edge behind that one
     * @param end the edge at the run's other end
     */
    int codeGrowth(
            BinaryCoder coder, int side, int count, int slots, int kind, int edge, int beyond, int end, int bit) {
        int part = side * COUNTS + Math.min(count, COUNTS - 1);
        int sum = CutTables.growth(0, part * (MOST_SLOTS + 1) + Math.min(slots, MOST_SLOTS))
                + GROWN[side * EDGES + edge]
                + BEYOND[side * EDGES + beyond]
                + OTHER_END[side * EDGES + end]
                + CutTables.growth(10, side * 8 + kind);
        return coder.bit(growths, part * LEVELS + level(sum), bit);
    }

    private static int level(int sum) {
        return Math.max(0, Math.min(LEVELS - 1, (sum + STEP * LEVELS / 2) / STEP));
    }
}
