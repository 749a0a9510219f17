package org.jsmesh.samples;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.zip.Adler32;
import java.util.zip.CRC32;

/**
 * Writes a PNG with a palette. It compresses by itself (RFC 1951, fixed codes): JVMs come with different zlibs, whose
 * bytes differ, and the same picture has to become the same file everywhere.
 */
final class PngBytes {
    private static final int[] LENGTH_BASE = {
        3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227,
        258
    };
    private static final int[] DISTANCE_BASE = {
        1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097,
        6145, 8193, 12289, 16385, 24577
    };
    private static final int WINDOW = 32768;
    private static final int TRIES = 48;

    private final ByteArrayOutputStream bits = new ByteArrayOutputStream();
    private int pending;
    private int pendingBits;

    private PngBytes() {}

    /** @param palette 0xRRGGBB of each index, at most 256; {@code pixels}: an index per pixel, rows from the top */
    static byte[] write(int width, int height, int[] palette, byte[] pixels) {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        png.writeBytes(new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'});
        byte[] head = ByteBuffer.allocate(13)
                .putInt(width)
                .putInt(height)
                .put(new byte[] {8, 3, 0, 0, 0})
                .array();
        chunk(png, "IHDR", head);
        byte[] colours = new byte[3 * palette.length];
        for (int i = 0; i < colours.length; i++) colours[i] = (byte) (palette[i / 3] >> 16 - 8 * (i % 3));
        chunk(png, "PLTE", colours);
        byte[] rows = new byte[(width + 1) * height];
        for (int y = 0; y < height; y++) System.arraycopy(pixels, y * width, rows, y * (width + 1) + 1, width);
        chunk(png, "IDAT", new PngBytes().deflate(rows));
        chunk(png, "IEND", new byte[0]);
        return png.toByteArray();
    }

    private static void chunk(ByteArrayOutputStream png, String type, byte[] data) {
        byte[] body = ByteBuffer.allocate(4 + data.length)
                .put(type.getBytes(StandardCharsets.US_ASCII))
                .put(data)
                .array();
        CRC32 crc = new CRC32();
        crc.update(body);
        png.writeBytes(ByteBuffer.allocate(4).putInt(data.length).array());
        png.writeBytes(body);
        png.writeBytes(ByteBuffer.allocate(4).putInt((int) crc.getValue()).array());
    }

    private byte[] deflate(byte[] data) {
        bits.write(0x78);
        bits.write(0x01);
        put(1, 1);
        put(1, 2);
        int[] head = new int[1 << 15];
        int[] previous = new int[data.length];
        Arrays.fill(head, -1);
        for (int at = 0; at < data.length; ) {
            int length = 0;
            int distance = 0;
            if (at + 3 <= data.length) {
                int candidate = head[hash(data, at)];
                for (int tries = 0; tries < TRIES && candidate >= 0 && at - candidate <= WINDOW; tries++) {
                    int n = common(data, candidate, at);
                    if (n > length) {
                        length = n;
                        distance = at - candidate;
                    }
                    candidate = previous[candidate];
                }
            }
            int step = length >= 3 ? length : 1;
            if (step == 1) literal(data[at] & 255);
            else match(length, distance);
            for (int end = at + step; at < end; at++) {
                if (at + 3 > data.length) continue;
                int slot = hash(data, at);
                previous[at] = head[slot];
                head[slot] = at;
            }
        }
        literal(256);
        put(0, 7);
        Adler32 sum = new Adler32();
        sum.update(data);
        bits.writeBytes(ByteBuffer.allocate(4).putInt((int) sum.getValue()).array());
        return bits.toByteArray();
    }

    private static int hash(byte[] data, int at) {
        int word = data[at] << 16 ^ data[at + 1] << 8 ^ data[at + 2];
        return word * 0x9e3779b1 >>> 17;
    }

    private static int common(byte[] data, int a, int b) {
        int n = 0;
        int most = StrictMath.min(258, data.length - b);
        while (n < most && data[a + n] == data[b + n]) n++;
        return n;
    }

    private void match(int length, int distance) {
        int l = place(LENGTH_BASE, length);
        literal(257 + l);
        put(length - LENGTH_BASE[l], l < 8 || l == 28 ? 0 : l / 4 - 1);
        int d = place(DISTANCE_BASE, distance);
        put(Integer.reverse(d) >>> 27, 5);
        put(distance - DISTANCE_BASE[d], d < 4 ? 0 : d / 2 - 1);
    }

    private static int place(int[] bases, int value) {
        int i = Arrays.binarySearch(bases, value);
        return i >= 0 ? i : -i - 2;
    }

    /** A symbol of the fixed code, most significant bit first. */
    private void literal(int symbol) {
        if (symbol < 144) code(0x30 + symbol, 8);
        else if (symbol < 256) code(0x190 + symbol - 144, 9);
        else if (symbol < 280) code(symbol - 256, 7);
        else code(0xc0 + symbol - 280, 8);
    }

    private void code(int code, int length) {
        put(Integer.reverse(code) >>> 32 - length, length);
    }

    private void put(int value, int count) {
        pending |= value << pendingBits;
        for (pendingBits += count; pendingBits >= 8; pendingBits -= 8) {
            bits.write(pending);
            pending >>>= 8;
        }
    }
}
