package org.jsmesh.files;

import org.jsmesh.mesh.Picture;

/**
 * The means of the 8 × 8 blocks of a progressive JPEG, an eighth of its size. The first scans bring only these means
 * (ITU T.81, annex G). They are enough for previews, and no library decodes such files in Java alone.
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

    private final byte[] file;
    private final int[] quantization = new int[4]; // of the mean
    private final JpegBits.Huffman[] tables = new JpegBits.Huffman[4];
    private Component[] components;
    private int width;
    private int height;
    private int restartInterval;
    private boolean isRgb;
    private int scanned; // components whose means are there

    private static final class Component {
        int id;
        int across; // blocks in a unit
        int down;
        int columns; // blocks, filled up to whole units
        int rows;
        int ownColumns; // blocks that the image needs
        int ownRows;
        int quantizer;
        int[] means; // in steps; null until its scan
        JpegBits.Huffman table;
        int last;
    }

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
     * The means as a picture.
     *
     * @throws IllegalArgumentException when the file is damaged or of a rare kind
     * @throws IndexOutOfBoundsException when it is cut
     */
    static Picture read(String path, byte[] file) {
        return new ProgressiveJpeg(file).read(path);
    }

    private Picture read(String path) {
        int at = 2;
        while (components == null || scanned < components.length) {
            if ((file[at] & 255) != 255) throw new IllegalArgumentException("no marker at " + at);
            int marker = file[at + 1] & 255;
            if (marker == 255) {
                at++;
                continue;
            }
            if (marker == END) throw new IllegalArgumentException("the file ends early");
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
        return picture(path);
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
        components = new Component[count];
        int across = 1;
        int down = 1;
        for (int i = 0; i < count; i++) {
            Component c = components[i] = new Component();
            c.id = file[at + 6 + 3 * i];
            c.across = file[at + 7 + 3 * i] >> 4 & 15;
            c.down = file[at + 7 + 3 * i] & 15;
            c.quantizer = file[at + 8 + 3 * i] & 3;
            if (c.across < 1 || c.across > 4 || c.down < 1 || c.down > 4)
                throw new IllegalArgumentException("a component of a rare kind");
            across = Math.max(across, c.across);
            down = Math.max(down, c.down);
        }
        int units = up(width, 8 * across);
        int unitRows = up(height, 8 * down);
        for (Component c : components) {
            c.columns = units * c.across;
            c.rows = unitRows * c.down;
            c.ownColumns = up(up(width * c.across, across), 8);
            c.ownRows = up(up(height * c.down, down), 8);
            if ((long) c.columns * c.rows > MOST_BLOCKS) throw new IllegalArgumentException("too large");
        }
    }

    private static int up(int value, int unit) {
        return (value + unit - 1) / unit;
    }

    private void readQuantization(int from, int end) {
        for (int at = from; at < end; ) {
            boolean isWide = file[at] >> 4 != 0;
            quantization[file[at] & 3] = isWide ? length(file, at + 1) : file[at + 1] & 255;
            at += isWide ? 129 : 65;
        }
    }

    private void readHuffman(int from, int end) {
        for (int at = from; at < end; ) {
            JpegBits.Huffman table = new JpegBits.Huffman(file, at + 1);
            if (file[at] >> 4 == 0) tables[file[at] & 3] = table;
            at += 17 + table.size;
        }
    }

    /** Reads a first scan of means and skips other scans. Returns the place of the next marker. */
    private int readScan(int body, int begin) {
        int count = file[body];
        int first = file[body + 1 + 2 * count];
        int refined = file[body + 3 + 2 * count] >> 4 & 15;
        int shift = file[body + 3 + 2 * count] & 15;
        if (first == 0 && refined == 0) {
            Component[] of = new Component[count];
            for (int i = 0; i < count; i++) of[i] = begun(file[body + 1 + 2 * i], file[body + 2 + 2 * i] >> 4 & 3);
            readMeans(of, shift, new JpegBits(file, begin));
        }
        int at = begin;
        while ((file[at] & 255) != 255 || file[at + 1] == 0 || (file[at + 1] & 0xf8) == 0xd0) at++;
        return at;
    }

    private Component begun(int id, int table) {
        for (Component c : components) {
            if (c.id != id) continue;
            if (c.means != null || tables[table] == null) break;
            c.means = new int[c.columns * c.rows];
            c.table = tables[table];
            scanned++;
            return c;
        }
        throw new IllegalArgumentException("a scan of a rare kind");
    }

    private void readMeans(Component[] of, int shift, JpegBits bits) {
        Component only = of.length == 1 ? of[0] : null;
        int columns = only != null ? only.ownColumns : of[0].columns / of[0].across;
        int rows = only != null ? only.ownRows : of[0].rows / of[0].down;
        for (int unit = 0; unit < columns * rows; unit++) {
            if (restartInterval > 0 && unit > 0 && unit % restartInterval == 0) {
                bits.restart();
                for (Component c : of) c.last = 0;
            }
            for (Component c : of) {
                int across = only != null ? 1 : c.across;
                int down = only != null ? 1 : c.down;
                for (int y = 0; y < down; y++)
                    for (int x = 0; x < across; x++) {
                        c.last += bits.difference(c.table.next(bits));
                        int at = (unit / columns * down + y) * c.columns + unit % columns * across + x;
                        c.means[at] = c.last << shift;
                    }
            }
        }
    }

    private Picture picture(String path) {
        int columns = up(width, 8);
        int rows = up(height, 8);
        int[] rgb = new int[columns * rows];
        int[] levels = new int[3];
        for (int i = 0; i < rgb.length; i++) {
            for (int k = 0; k < components.length; k++) levels[k] = level(components[k], i % columns, i / columns);
            if (components.length == 1) rgb[i] = levels[0] * 0x10101;
            else if (isRgb) rgb[i] = levels[0] << 16 | levels[1] << 8 | levels[2];
            else rgb[i] = colour(levels[0], levels[1] - 128, levels[2] - 128);
        }
        return new Picture(path, columns, rows, rgb);
    }

    private int level(Component c, int column, int row) {
        Component full = components[0];
        int x = column * c.across / full.across;
        int y = row * c.down / full.down;
        int at = Math.min(y, c.rows - 1) * c.columns + Math.min(x, c.columns - 1);
        return limited(128 + (c.means[at] * quantization[c.quantizer] >> 3));
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
