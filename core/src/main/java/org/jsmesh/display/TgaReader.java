package org.jsmesh.display;

import java.util.Arrays;

/**
 * Reads Truevision TGA (file format specification 2.0): colours, shades of grey and colour maps, run-length encoded or
 * not. The format has no mark at its beginning, so a file is told by a header that makes sense.
 */
final class TgaReader {
    private static final int HEADER = 18;
    private static final int RUN_LENGTH = 8;
    private static final int MAPPED = 1;
    private static final int COLOURS = 2;
    private static final int GREY = 3;
    /** Images that claim more pixels are not read. */
    private static final int MOST_PIXELS = 1 << 26;
    /** Most pixels of a packet. */
    private static final int PACKET = 128;

    private final byte[] file;
    private final int kind;
    private final boolean runs;
    private final int bits;
    private final boolean alpha;
    private final int width;
    private final int height;
    private int[] map;
    private int at;
    private boolean cut;

    TgaReader(byte[] file) {
        this.file = file;
        kind = file[2] & 7;
        runs = (file[2] & RUN_LENGTH) != 0;
        width = word(file, 12);
        height = word(file, 14);
        bits = file[16];
        alpha = (file[17] & 15) != 0;
        at = HEADER + (file[0] & 255);
    }

    static boolean isTga(byte[] file) {
        if (file.length < HEADER) return false;
        int kind = file[2] & ~RUN_LENGTH;
        int bits = file[16];
        long pixels = (long) word(file, 12) * word(file, 14);
        boolean depth = switch (kind) {
            case MAPPED -> bits == 8 && file[1] == 1 && isColour(file[7]);
            case COLOURS -> isColour(bits);
            case GREY -> bits == 8 || bits == 16;
            default -> false;
        };
        if (!depth || file[1] < 0 || file[1] > 1 || pixels < 1 || pixels > MOST_PIXELS) return false;
        if ((file[17] & 0xC0) != 0) return false;
        boolean isEncoded = (file[2] & RUN_LENGTH) != 0;
        long least = isEncoded ? (pixels + PACKET - 1) / PACKET * (1 + (bits + 7) / 8) : pixels * ((bits + 7) / 8);
        return file.length - HEADER - (file[0] & 255) >= least;
    }

    private static boolean isColour(int bits) {
        return bits == 15 || bits == 16 || bits == 24 || bits == 32;
    }

    /** Null when the file is shorter than it says. */
    Raster read() {
        readMap();
        int[] argb = new int[width * height];
        int done = 0;
        while (done < argb.length && !cut) done = packet(argb, done);
        if (cut) return null;
        boolean fromTop = (file[17] & 0x20) != 0;
        boolean fromRight = (file[17] & 0x10) != 0;
        if (!fromTop) turnOver(argb);
        if (fromRight) mirror(argb);
        if (!alpha || isUnseen(argb)) for (int i = 0; i < argb.length; i++) argb[i] |= 0xff000000;
        return new Raster(width, height, argb);
    }

    private void readMap() {
        int entries = word(file, 5);
        if (file[1] == 0 || entries == 0) return;
        map = new int[word(file, 3) + entries];
        for (int i = map.length - entries; i < map.length; i++) map[i] = colour(file[7]);
    }

    private int packet(int[] argb, int done) {
        if (!runs) {
            argb[done] = pixel();
            return done + 1;
        }
        int head = take();
        int end = Math.min(argb.length, done + (head & 127) + 1);
        if (head < PACKET) {
            for (int i = done; i < end; i++) argb[i] = pixel();
        } else {
            Arrays.fill(argb, done, end, pixel());
        }
        return end;
    }

    private int pixel() {
        if (kind == COLOURS) return colour(bits);
        int value = take();
        if (kind == MAPPED) return map != null && value < map.length ? map[value] : 0xff000000;
        int opacity = bits == 16 ? take() : 255;
        return opacity << 24 | value << 16 | value << 8 | value;
    }

    private int colour(int depth) {
        int low = take();
        int middle = take();
        if (depth <= 16) {
            int five = middle << 8 | low;
            int opacity = depth == 16 && alpha && five < 0x8000 ? 0 : 255;
            return opacity << 24 | eight(five >> 10) << 16 | eight(five >> 5) << 8 | eight(five);
        }
        int high = take();
        int opacity = depth == 32 ? take() : 255;
        return opacity << 24 | high << 16 | middle << 8 | low;
    }

    private static int eight(int five) {
        int value = five & 31;
        return value << 3 | value >> 2;
    }

    private int take() {
        if (at < file.length) return file[at++] & 255;
        cut = true;
        return 0;
    }

    private void turnOver(int[] argb) {
        int[] row = new int[width];
        for (int y = 0; y < height / 2; y++) {
            int other = (height - 1 - y) * width;
            System.arraycopy(argb, y * width, row, 0, width);
            System.arraycopy(argb, other, argb, y * width, width);
            System.arraycopy(row, 0, argb, other, width);
        }
    }

    private void mirror(int[] argb) {
        for (int y = 0; y < height; y++) {
            for (int left = y * width, right = left + width - 1; left < right; left++, right--) {
                int pixel = argb[left];
                argb[left] = argb[right];
                argb[right] = pixel;
            }
        }
    }

    /** Some programs say that there is opacity and leave it 0 everywhere. */
    private static boolean isUnseen(int[] argb) {
        for (int pixel : argb) if (pixel >>> 24 != 0) return false;
        return true;
    }

    private static int word(byte[] file, int at) {
        return file[at] & 255 | (file[at + 1] & 255) << 8;
    }
}
