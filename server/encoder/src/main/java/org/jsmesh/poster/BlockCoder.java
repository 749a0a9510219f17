package org.jsmesh.poster;

/** Codes blocks of coefficients (ITU T.81, F.1.2), or counts the symbols that this takes. */
final class BlockCoder {
    private static final int BLOCK = 64;
    private static final int SIXTEEN_ZEROS = 0xf0;

    private final HuffmanTable[] tables;
    private final BitSink bits;
    private final int[] last = new int[3]; // first coefficient of the block before, by plane

    /**
     * @param tables of the brightness, then of colours: for the first coefficient, then for the others
     * @param bits takes the code; null to count symbols
     */
    BlockCoder(HuffmanTable[] tables, BitSink bits) {
        this.tables = tables;
        this.bits = bits;
    }

    /** Codes the block that begins at a place. */
    void code(int[] coefficients, int at, int plane) {
        int pair = plane == 0 ? 0 : 2;
        int difference = coefficients[at] - last[plane];
        last[plane] = coefficients[at];
        put(tables[pair], size(difference), difference, size(difference));
        int zeros = 0;
        for (int i = 1; i < BLOCK; i++) {
            int value = coefficients[at + i];
            if (value == 0) {
                zeros++;
                continue;
            }
            for (; zeros > 15; zeros -= 16) put(tables[pair + 1], SIXTEEN_ZEROS, 0, 0);
            put(tables[pair + 1], zeros << 4 | size(value), value, size(value));
            zeros = 0;
        }
        if (zeros > 0) put(tables[pair + 1], 0, 0, 0);
    }

    private static int size(int value) {
        return 32 - Integer.numberOfLeadingZeros(Math.abs(value));
    }

    private void put(HuffmanTable table, int symbol, int value, int size) {
        if (bits == null) {
            table.count(symbol);
            return;
        }
        bits.put(table.code(symbol), table.length(symbol));
        bits.put((value < 0 ? value - 1 : value) & (1 << size) - 1, size);
    }
}
