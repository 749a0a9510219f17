package org.jsmesh.files;

/** A component of a progressive JPEG: luma or a difference of colours, in blocks of 8 × 8 pixels. */
final class JpegComponent {
    /** Pixels along a side of a block. */
    static final int SIDE = 8;
    /** Numbers of a block. */
    static final int BLOCK = SIDE * SIDE;

    private static final int[] ZIGZAG = zigzag();
    private static final int BITS = 13;
    /** Waves by frequency and place, in 2^−13. */
    private static final int[] WAVES = waves();

    final int id;
    final int across; // blocks in a unit
    final int down;
    final int quantizer;
    int columns; // blocks, filled up to whole units
    int rows;
    int ownColumns; // blocks that the image needs
    int ownRows;
    boolean isBegun; // its means are there, perhaps coarsely
    int last; // mean in the scan under way
    private int kept; // numbers of a block: all, or the mean alone
    private short[] numbers; // in steps, block after block
    private byte[] levels; // 0 to 255

    JpegComponent(int id, int across, int down, int quantizer) {
        this.id = id;
        this.across = across;
        this.down = down;
        this.quantizer = quantizer;
    }

    /** @param isWhole whether all numbers of the blocks are kept, not the means alone */
    void allocate(boolean isWhole) {
        kept = isWhole ? BLOCK : 1;
        numbers = new short[columns * rows * kept];
    }

    int number(int block, int place) {
        return numbers[block * kept + ZIGZAG[place]];
    }

    void set(int block, int place, int number) {
        numbers[block * kept + ZIGZAG[place]] = (short) number;
    }

    /** Ends the reading of numbers. */
    void finish(int[] quantization) {
        int side = kept == 1 ? 1 : SIDE;
        levels = new byte[columns * rows * kept];
        int[] block = new int[BLOCK];
        int[] half = new int[BLOCK];
        for (int b = 0; b < columns * rows; b++) {
            int from = (b / columns * side * columns + b % columns) * side;
            if (kept == 1) {
                levels[from] = level(numbers[b] * quantization[0] + 4 >> 3);
                continue;
            }
            for (int k = 0; k < BLOCK; k++) block[ZIGZAG[k]] = number(b, k) * quantization[k];
            // Rows, then columns.
            for (int i = 0; i < BLOCK; i++) half[i] = sum(block, i & -SIDE, 1, i & 7, BITS - 3);
            for (int i = 0; i < BLOCK; i++)
                levels[from + (i >> 3) * columns * side + (i & 7)] = level(sum(half, i & 7, SIDE, i >> 3, BITS + 3));
        }
        numbers = null;
    }

    /** The level at a pixel, or of a block where the means alone are kept. */
    int level(int x, int y) {
        int side = kept == 1 ? 1 : SIDE;
        int width = columns * side;
        return levels[Math.min(y, rows * side - 1) * width + Math.min(x, width - 1)] & 255;
    }

    private static int sum(int[] of, int first, int stride, int place, int shift) {
        long sum = 1L << shift - 1;
        for (int k = 0; k < SIDE; k++) sum += (long) of[first + k * stride] * WAVES[k * SIDE + place];
        return (int) (sum >> shift);
    }

    private static byte level(int value) {
        return (byte) Math.max(0, Math.min(255, 128 + value));
    }

    private static int[] waves() {
        int[] waves = new int[BLOCK];
        for (int k = 0; k < SIDE; k++)
            for (int x = 0; x < SIDE; x++) {
                double wave = StrictMath.cos((2 * x + 1) * k * Math.PI / 16) / 2 * (k == 0 ? StrictMath.sqrt(.5) : 1);
                waves[k * SIDE + x] = (int) Math.round(wave * (1 << BITS));
            }
        return waves;
    }

    /** Places by their order in the file (ITU T.81, figure A.6): along diagonals, in turns up and down. */
    private static int[] zigzag() {
        int[] places = new int[BLOCK];
        int n = 0;
        for (int sum = 0; sum < 2 * SIDE - 1; sum++)
            for (int k = 0; k <= sum; k++) {
                int row = sum % 2 == 0 ? sum - k : k;
                if (row < SIDE && sum - row < SIDE) places[n++] = row * SIDE + sum - row;
            }
        return places;
    }
}
