package org.jsmesh.files;

import java.awt.image.BufferedImage;

/**
 * Reads progressive JPEG (ITU T.81, annex G), which no library decodes in Java alone. Of a very large file it reads the
 * means of the 8 × 8 blocks alone.
 */
final class ProgressiveJpeg {
    private static final int START = 0xd8;
    private static final int PROGRESSIVE_FRAME = 0xc2;
    private static final int HUFFMAN_TABLES = 0xc4;
    private static final int END = 0xd9;
    private static final int SCAN = 0xda;
    private static final int QUANTIZATION_TABLES = 0xdb;
    private static final int RESTART_INTERVAL = 0xdd;
    private static final int ADOBE = 0xee;
    private static final long MOST_BLOCKS = 1 << 22;
    /** Of more blocks the means are kept alone: all numbers would need too much memory. */
    private static final long MOST_WHOLE = 1 << 20;

    private final byte[] file;
    private final int[][] quantization = new int[4][];
    private final JpegBits.Huffman[] ofMeans = new JpegBits.Huffman[4];
    private final JpegBits.Huffman[] ofOthers = new JpegBits.Huffman[4];
    private JpegComponent[] components;
    private int width;
    private int height;
    private boolean isWhole;
    private int restartInterval;
    private boolean isRgb;

    private ProgressiveJpeg(byte[] file) {
        this.file = file;
    }

    /** True for files that this class can read. */
    static boolean is(byte[] file) {
        int frame = -1;
        for (int at = 2; at + 4 <= file.length && (file[at] & 255) == 255; at += 2 + length(file, at + 2)) {
            int marker = file[at + 1] & 255;
            if (marker >= 0xc0 && marker <= 0xcf && marker != HUFFMAN_TABLES && marker != 0xc8 && marker != 0xcc)
                frame = marker;
            if (frame >= 0 || marker == SCAN || length(file, at + 2) < 2) break;
        }
        return file.length > 2 && (file[0] & 255) == 255 && (file[1] & 255) == START && frame == PROGRESSIVE_FRAME;
    }

    /**
     * Reads a file.
     *
     * @return the image; of a very large file an eighth of its size
     * @throws IllegalArgumentException when the file is damaged or of a rare kind
     * @throws IndexOutOfBoundsException when it is cut
     */
    static BufferedImage read(byte[] file) {
        return new ProgressiveJpeg(file).read();
    }

    private BufferedImage read() {
        int at = 2;
        while (true) {
            if ((file[at] & 255) != 255) throw new IllegalArgumentException("no marker at " + at);
            int marker = file[at + 1] & 255;
            if (marker == 255) {
                at++;
                continue;
            }
            if (marker == END) return image();
            int body = at + 4;
            int end = at + 2 + length(file, at + 2);
            switch (marker) {
                case PROGRESSIVE_FRAME -> readFrame(body);
                case HUFFMAN_TABLES -> readHuffman(body, end);
                case QUANTIZATION_TABLES -> readQuantization(body, end);
                case RESTART_INTERVAL -> restartInterval = length(file, body);
                case ADOBE -> isRgb = end - body >= 12 && file[body] == 'A' && file[body + 11] == 0;
                case SCAN -> end = readScan(body, end);
                default -> {
                    // Comments, profiles and the like.
                }
            }
            at = end;
        }
    }

    private static int length(byte[] file, int at) {
        return (file[at] & 255) << 8 | file[at + 1] & 255;
    }

    private void readFrame(int at) {
        height = length(file, at + 1);
        width = length(file, at + 3);
        int count = file[at + 5];
        if (components != null || file[at] != 8 || width == 0 || height == 0 || count != 1 && count != 3)
            throw new IllegalArgumentException("a frame of a rare kind");
        components = new JpegComponent[count];
        int across = 1;
        int down = 1;
        for (int i = 0; i < count; i++) {
            int from = at + 6 + 3 * i;
            JpegComponent c =
                    new JpegComponent(file[from], file[from + 1] >> 4 & 15, file[from + 1] & 15, file[from + 2] & 3);
            if (c.across < 1 || c.across > 4 || c.down < 1 || c.down > 4)
                throw new IllegalArgumentException("a component of a rare kind");
            components[i] = c;
            across = Math.max(across, c.across);
            down = Math.max(down, c.down);
        }
        int units = up(width, 8 * across);
        int unitRows = up(height, 8 * down);
        long blocks = 0;
        for (JpegComponent c : components) {
            c.columns = units * c.across;
            c.rows = unitRows * c.down;
            c.ownColumns = up(up(width * c.across, across), 8);
            c.ownRows = up(up(height * c.down, down), 8);
            blocks += (long) c.columns * c.rows;
        }
        if (blocks > MOST_BLOCKS) throw new IllegalArgumentException("too large");
        isWhole = blocks <= MOST_WHOLE;
        for (JpegComponent c : components) c.allocate(isWhole);
    }

    private static int up(int value, int unit) {
        return (value + unit - 1) / unit;
    }

    private void readQuantization(int from, int end) {
        for (int at = from; at < end; ) {
            boolean isWide = file[at] >> 4 != 0;
            int[] table = quantization[file[at] & 3] = new int[JpegComponent.BLOCK];
            at++;
            for (int k = 0; k < table.length; k++, at += isWide ? 2 : 1)
                table[k] = isWide ? length(file, at) : file[at] & 255;
        }
    }

    private void readHuffman(int from, int end) {
        for (int at = from; at < end; ) {
            JpegBits.Huffman table = new JpegBits.Huffman(file, at + 1);
            (file[at] >> 4 == 0 ? ofMeans : ofOthers)[file[at] & 3] = table;
            at += 17 + table.size;
        }
    }

    /** Reads a scan, or skips it where the means alone are kept. Returns the place of the next marker. */
    private int readScan(int body, int begin) {
        int count = file[body];
        int first = file[body + 1 + 2 * count];
        int last = file[body + 2 + 2 * count];
        boolean isRefining = (file[body + 3 + 2 * count] >> 4 & 15) != 0;
        int shift = file[body + 3 + 2 * count] & 15;
        if (components == null || count < 1 || count > components.length || first < 0 || last >= JpegComponent.BLOCK)
            throw new IllegalArgumentException("a scan of a rare kind");
        if (first == 0 || isWhole) {
            JpegComponent[] of = new JpegComponent[count];
            JpegBits.Huffman[] tables = new JpegBits.Huffman[count];
            for (int i = 0; i < count; i++) {
                of[i] = component(file[body + 1 + 2 * i], first == 0 && !isRefining);
                int table = file[body + 2 + 2 * i];
                tables[i] = first == 0 ? ofMeans[table >> 4 & 3] : ofOthers[table & 3];
                if (tables[i] == null && !(first == 0 && isRefining))
                    throw new IllegalArgumentException("a table is missing");
            }
            if (first == 0 ? last > 0 : count > 1) throw new IllegalArgumentException("a scan of a rare kind");
            new JpegScan(of, tables, first, last, shift).read(new JpegBits(file, begin), restartInterval, isRefining);
        }
        int at = begin;
        while ((file[at] & 255) != 255 || file[at + 1] == 0 || (file[at + 1] & 0xf8) == 0xd0) at++;
        return at;
    }

    private JpegComponent component(int id, boolean begins) {
        for (JpegComponent c : components) {
            if (c.id != id) continue;
            if (c.isBegun == begins) break;
            c.isBegun = true;
            return c;
        }
        throw new IllegalArgumentException("a scan of a rare kind");
    }

    private BufferedImage image() {
        if (components == null) throw new IllegalArgumentException("the file ends early");
        for (JpegComponent c : components) {
            if (!c.isBegun || quantization[c.quantizer] == null)
                throw new IllegalArgumentException("the file ends early");
            c.finish(quantization[c.quantizer]);
        }
        int columns = isWhole ? width : up(width, JpegComponent.SIDE);
        int rows = isWhole ? height : up(height, JpegComponent.SIDE);
        BufferedImage image = new BufferedImage(columns, rows, BufferedImage.TYPE_INT_RGB);
        int[] row = new int[columns];
        int[] levels = new int[3];
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                for (int k = 0; k < components.length; k++) levels[k] = level(components[k], x, y);
                if (components.length == 1) row[x] = levels[0] * 0x10101;
                else if (isRgb) row[x] = levels[0] << 16 | levels[1] << 8 | levels[2];
                else row[x] = colour(levels[0], levels[1] - 128, levels[2] - 128);
            }
            image.setRGB(0, y, columns, 1, row, 0, columns);
        }
        return image;
    }

    private int level(JpegComponent c, int x, int y) {
        return c.level(x * c.across / components[0].across, y * c.down / components[0].down);
    }

    /** JFIF's colours, in 65536ths. */
    private static int colour(int luma, int blueness, int redness) {
        int red = luma + (91881 * redness + 32768 >> 16);
        int green = luma - (22554 * blueness + 46802 * redness + 32768 >> 16);
        int blue = luma + (116130 * blueness + 32768 >> 16);
        return limited(red) << 16 | limited(green) << 8 | limited(blue);
    }

    private static int limited(int level) {
        return Math.max(0, Math.min(255, level));
    }
}
