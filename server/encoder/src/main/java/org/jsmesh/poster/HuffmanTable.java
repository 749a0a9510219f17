package org.jsmesh.poster;

/**
 * The shortest prefix code for symbols as often as they were counted, no code longer than 16 bits and none of ones
 * alone (ITU T.81, K.2 and C).
 */
final class HuffmanTable {
    private static final int SYMBOLS = 256;
    private static final int MOST_BITS = 16;

    private final long[] counts = new long[SYMBOLS + 1];
    private final int[] lengths = new int[SYMBOLS + 1];
    private final int[] codes = new int[SYMBOLS];

    void count(int symbol) {
        counts[symbol]++;
    }

    /** Makes the code of what was counted. */
    void build() {
        counts[SYMBOLS] = 1; // takes the code of ones alone; it is the rarest and so the last one
        long[] left = counts.clone();
        int[] next = new int[SYMBOLS + 1]; // symbols below one node of the tree are chained
        java.util.Arrays.fill(next, -1);
        while (true) {
            int rarest = rarest(left, -1);
            int second = rarest(left, rarest);
            if (second < 0) break;
            left[second] += left[rarest];
            left[rarest] = 0;
            int end = second;
            for (; next[end] >= 0; end = next[end]) lengths[end]++;
            lengths[end]++;
            next[end] = rarest;
            for (int s = rarest; s >= 0; s = next[s]) lengths[s]++;
        }
        number(shortened());
    }

    /** The symbol with the smallest count above 0, of several the last one; −1 for none. */
    private static int rarest(long[] counts, int but) {
        int found = -1;
        for (int s = 0; s < counts.length; s++)
            if (counts[s] > 0 && s != but && (found < 0 || counts[s] <= counts[found])) found = s;
        return found;
    }

    /** Numbers of codes by their length, after long ones were exchanged for shorter ones (figure K.3). */
    private int[] shortened() {
        int[] ofLength = new int[SYMBOLS + 2];
        for (int length : lengths) ofLength[length]++;
        ofLength[0] = 0;
        for (int i = SYMBOLS + 1; i > MOST_BITS; i--) {
            while (ofLength[i] > 0) {
                int shorter = i - 2;
                while (ofLength[shorter] == 0) shorter--;
                ofLength[i] -= 2;
                ofLength[i - 1]++;
                ofLength[shorter + 1] += 2;
                ofLength[shorter]--;
            }
        }
        return ofLength;
    }

    /** Gives codes to the symbols, the frequent ones first. */
    private void number(int[] ofLength) {
        int[] order = order();
        int code = 0;
        int at = 0;
        for (int length = 1; length <= MOST_BITS; length++, code <<= 1) {
            for (int i = 0; i < ofLength[length]; i++, at++, code++) {
                int symbol = order[at];
                lengths[symbol] = length;
                if (symbol < SYMBOLS) codes[symbol] = code;
            }
        }
    }

    /** Symbols by the length that they had without a limit; the one that is none comes last. */
    private int[] order() {
        return java.util.stream.IntStream.range(0, lengths.length)
                .filter(s -> lengths[s] > 0)
                .boxed()
                .sorted(java.util.Comparator.<Integer>comparingInt(s -> s == SYMBOLS ? SYMBOLS + 2 : lengths[s])
                        .thenComparingInt(s -> s))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    int code(int symbol) {
        return codes[symbol];
    }

    int length(int symbol) {
        return lengths[symbol];
    }

    /** What the file says of the table: class and number, how many codes of each length, symbols in their order. */
    int[] segment(int name) {
        int[] order = order();
        int symbols = order.length - 1;
        int[] segment = new int[1 + MOST_BITS + symbols];
        segment[0] = name;
        for (int i = 0; i < symbols; i++) {
            segment[lengths[order[i]]]++;
            segment[1 + MOST_BITS + i] = order[i];
        }
        return segment;
    }
}
