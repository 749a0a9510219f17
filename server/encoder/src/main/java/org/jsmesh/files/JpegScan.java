package org.jsmesh.files;

/** A scan of a progressive JPEG (ITU T.81, annex G): some numbers of the blocks, or a further bit of them. */
final class JpegScan {
    private final JpegComponent[] of;
    private final JpegBits.Huffman[] tables; // one per component
    private final int first; // numbers of a block, in the order of the file
    private final int last;
    private final int shift;
    private int run; // blocks to come without a new number

    /**
     * @param tables one per component; null where the scan needs none
     * @param first of the numbers of each block, in the order of the file
     * @param last likewise
     * @param shift bits that a later scan brings
     */
    JpegScan(JpegComponent[] of, JpegBits.Huffman[] tables, int first, int last, int shift) {
        this.of = of;
        this.tables = tables;
        this.first = first;
        this.last = last;
        this.shift = shift;
    }

    /** @param isRefining whether the scan brings a further bit */
    void read(JpegBits bits, int restartInterval, boolean isRefining) {
        JpegComponent only = of.length == 1 ? of[0] : null;
        int columns = only != null ? only.ownColumns : of[0].columns / of[0].across;
        int rows = only != null ? only.ownRows : of[0].rows / of[0].down;
        for (JpegComponent c : of) c.last = 0;
        for (int unit = 0; unit < columns * rows; unit++) {
            if (restartInterval > 0 && unit > 0 && unit % restartInterval == 0) {
                bits.restart();
                run = 0;
                for (JpegComponent c : of) c.last = 0;
            }
            for (int i = 0; i < of.length; i++) {
                JpegComponent c = of[i];
                int across = only != null ? 1 : c.across;
                int down = only != null ? 1 : c.down;
                for (int k = 0; k < across * down; k++) {
                    int row = unit / columns * down + k / across;
                    int block = row * c.columns + unit % columns * across + k % across;
                    if (first == 0) readMean(c, tables[i], block, bits, isRefining);
                    else if (isRefining) refine(c, block, bits);
                    else readNumbers(c, block, bits);
                }
            }
        }
    }

    private void readMean(JpegComponent c, JpegBits.Huffman table, int block, JpegBits bits, boolean isRefining) {
        if (isRefining) {
            c.set(block, 0, c.number(block, 0) | bits.next() << shift);
            return;
        }
        c.last += bits.difference(table.next(bits));
        c.set(block, 0, c.last << shift);
    }

    private void readNumbers(JpegComponent c, int block, JpegBits bits) {
        if (run > 0) {
            run--;
            return;
        }
        for (int k = first; k <= last; k++) {
            int code = tables[0].next(bits);
            int zeros = code >> 4;
            int length = code & 15;
            if (length == 0 && zeros < 15) {
                run = runOf(zeros, bits) - 1;
                return;
            }
            k += zeros;
            if (k > last) throw new IllegalArgumentException("a block of too many numbers");
            if (length > 0) c.set(block, k, bits.difference(length) << shift);
        }
    }

    /** Numbers that are there get a further bit, others appear. */
    private void refine(JpegComponent c, int block, JpegBits bits) {
        int k = first;
        while (run == 0 && k <= last) {
            int code = tables[0].next(bits);
            int zeros = code >> 4;
            if ((code & 15) == 0 && zeros < 15) {
                run = runOf(zeros, bits);
                break;
            }
            int appearing = (code & 15) == 0 ? 0 : bits.next() != 0 ? 1 << shift : -1 << shift;
            for (; k <= last; k++) {
                if (c.number(block, k) != 0) addBit(c, block, k, bits);
                else if (zeros-- == 0) break;
            }
            if (k <= last && appearing != 0) c.set(block, k, appearing);
            k++;
        }
        if (run == 0) return;
        for (; k <= last; k++) if (c.number(block, k) != 0) addBit(c, block, k, bits);
        run--;
    }

    private void addBit(JpegComponent c, int block, int k, JpegBits bits) {
        if (bits.next() == 0) return;
        int number = c.number(block, k);
        c.set(block, k, number + (number > 0 ? 1 << shift : -1 << shift));
    }

    private static int runOf(int length, JpegBits bits) {
        int more = 0;
        for (int i = 0; i < length; i++) more = more << 1 | bits.next();
        return (1 << length) + more;
    }
}
