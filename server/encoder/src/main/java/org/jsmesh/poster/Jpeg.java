package org.jsmesh.poster;

import java.io.ByteArrayOutputStream;

/**
 * A picture as a JPEG file (ITU T.81, baseline, JFIF): colours at half the resolution, code tables made for the
 * picture. All arithmetic is of integers, so the bytes are the same everywhere. Other writers, such as that of Java,
 * differ from platform to platform.
 */
final class Jpeg {
    private static final int BLOCK = 64;
    /** Largest steps of the mean of a block: with larger ones the ground has rings, and another tone. */
    private static final int[] COARSEST_MEAN = {6, 3};

    /** T.81, table K.1 and K.2: steps of the coefficients, row by row. */
    private static final int[][] STEPS = {
        {
            16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22,
            29, 51, 87, 80, 62, 18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, 49, 64, 78, 87, 103,
            121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99
        },
        {
            17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99, 99, 99, 47, 66, 99,
            99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
            99, 99, 99, 99, 99, 99, 99, 99, 99, 99
        }
    };
    /** T.81, figure A.6: where the coefficients of the sequence lie. */
    private static final int[] ZIGZAG = {
        0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14,
        21, 28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60,
        61, 54, 47, 55, 62, 63
    };

    private final int width;
    private final int height;
    private final int across; // units of 16 x 16 pixels
    private final int down;
    /** Coefficients, in {@link Cosines#SCALE}ths, of all blocks in the order of the file. */
    private final int[] coefficients;

    /** @param rgb red from the third byte on, row by row from the top */
    Jpeg(int width, int height, int[] rgb) {
        this.width = width;
        this.height = height;
        across = (width + 15) / 16;
        down = (height + 15) / 16;
        coefficients = new int[across * down * 6 * BLOCK];
        int[][] planes = Planes.of(width, height, rgb, across * 16, down * 16);
        int at = 0;
        for (int unit = 0; unit < across * down; unit++) {
            int x = unit % across;
            int y = unit / across;
            for (int b = 0; b < 4; b++, at += BLOCK)
                Cosines.transform(planes[0], across * 16, 16 * x + 8 * (b % 2), 16 * y + 8 * (b / 2), coefficients, at);
            for (int c = 1; c < 3; c++, at += BLOCK)
                Cosines.transform(planes[c], across * 8, 8 * x, 8 * y, coefficients, at);
        }
    }

    /** The finest file of at most so many bytes; the coarsest one if none is so small. */
    byte[] within(int bytes, int finest) {
        int low = 1;
        int high = finest;
        while (low < high) {
            int middle = (low + high + 1) / 2;
            if (file(middle).length <= bytes) low = middle;
            else high = middle - 1;
        }
        return file(low);
    }

    /** @param quality 1 to 100, on the scale that most programs have for JPEG */
    byte[] file(int quality) {
        int[][] steps = {steps(0, quality), steps(1, quality)};
        int[] quantized = quantized(steps);
        HuffmanTable[] tables = new HuffmanTable[4]; // of both kinds of planes: first coefficients, then others
        for (int i = 0; i < 4; i++) tables[i] = new HuffmanTable();
        code(quantized, new BlockCoder(tables, null));
        for (HuffmanTable table : tables) table.build();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        segment(out, 0xd8);
        segment(out, 0xe0, 'J', 'F', 'I', 'F', 0, 1, 1, 0, 0, 1, 0, 1, 0, 0);
        for (int t = 0; t < 2; t++) {
            int[] body = new int[1 + BLOCK];
            body[0] = t;
            for (int i = 0; i < BLOCK; i++) body[1 + i] = steps[t][ZIGZAG[i]];
            segment(out, 0xdb, body);
        }
        segment(
                out,
                0xc0,
                8,
                height >> 8,
                height & 255,
                width >> 8,
                width & 255,
                3,
                1,
                0x22,
                0,
                2,
                0x11,
                1,
                3,
                0x11,
                1);
        for (int t = 0; t < 4; t++) segment(out, 0xc4, tables[t].segment((t & 1) << 4 | t >> 1));
        segment(out, 0xda, 3, 1, 0x00, 2, 0x11, 3, 0x11, 0, 63, 0);
        BitSink bits = new BitSink(out);
        code(quantized, new BlockCoder(tables, bits));
        bits.finish();
        segment(out, 0xd9);
        return out.toByteArray();
    }

    private static int[] steps(int table, int quality) {
        int percent = quality < 50 ? 5000 / quality : 200 - 2 * quality;
        int[] steps = new int[BLOCK];
        for (int i = 0; i < BLOCK; i++) steps[i] = Math.max(1, Math.min(255, (STEPS[table][i] * percent + 50) / 100));
        steps[0] = Math.min(steps[0], COARSEST_MEAN[table]);
        return steps;
    }

    /** The coefficients in steps, in the order of the sequence. */
    private int[] quantized(int[][] steps) {
        int[] quantized = new int[coefficients.length];
        for (int at = 0; at < coefficients.length; at += BLOCK) {
            int[] step = steps[at / BLOCK % 6 < 4 ? 0 : 1];
            for (int i = 0; i < BLOCK; i++) {
                int value = coefficients[at + ZIGZAG[i]];
                int unit = step[ZIGZAG[i]] * Cosines.SCALE;
                // Small details cost more than they show.
                int magnitude = (Math.abs(value) + (i == 0 ? unit / 2 : unit * 2 / 5)) / unit;
                quantized[at + i] = value < 0 ? -magnitude : magnitude;
            }
        }
        return quantized;
    }

    private static void code(int[] quantized, BlockCoder coder) {
        for (int at = 0; at < quantized.length; at += BLOCK) {
            int block = at / BLOCK % 6;
            coder.code(quantized, at, Math.max(0, block - 3));
        }
    }

    private static void segment(ByteArrayOutputStream out, int marker, int... body) {
        out.write(0xff);
        out.write(marker);
        if (body.length == 0) return;
        out.write(body.length + 2 >> 8);
        out.write(body.length + 2);
        for (int value : body) out.write(value);
    }
}
