package org.jsmesh.display;

import java.util.zip.CRC32;

/**
 * The pixels of an image.
 *
 * @param width in pixels
 * @param height in pixels
 * @param argb alpha, red, green, blue from the highest byte on, not premultiplied; row by row from the top. Shared
 */
public record Raster(int width, int height, int[] argb) {
    private static final int OPAQUE = 0xff;
    /** Bytes of a block that is stored, not compressed (RFC 1951, 3.2.4). */
    private static final int BLOCK = 65535;

    private static final int ADLER = 65521;
    /** Bytes after which the sums of Adler-32 still fit 32 bits. */
    private static final int ADLER_RUN = 3800;

    /**
     * Checks the size.
     *
     * @param width see {@link #width()}
     * @param height see {@link #height()}
     * @param argb see {@link #argb()}
     * @throws IllegalArgumentException when there are not width × height pixels
     */
    public Raster {
        if (width < 1 || height < 1 || argb.length != (long) width * height)
            throw new IllegalArgumentException(argb.length + " pixels for " + width + " x " + height);
    }

    /**
     * Reads a TGA image, which browsers and Java do not.
     *
     * @param file the bytes of any file
     * @return its pixels, or null when it is no TGA image or a damaged one
     */
    public static Raster ofTga(byte[] file) {
        return TgaReader.isTga(file) ? new TgaReader(file).read() : null;
    }

    /** {@return whether a pixel is not wholly opaque} */
    public boolean hasAlpha() {
        for (int pixel : argb) if (pixel >>> 24 != OPAQUE) return true;
        return false;
    }

    /** {@return the image as a PNG file, not compressed, which every browser reads} */
    public byte[] png() {
        int bytesPerPixel = hasAlpha() ? 4 : 3;
        byte[] rows = rows(bytesPerPixel);
        int blocks = Math.max(1, (rows.length + BLOCK - 1) / BLOCK);
        byte[] file = new byte[8 + 12 + 13 + 12 + 2 + 5 * blocks + rows.length + 4 + 12];
        byte[] signature = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10};
        System.arraycopy(signature, 0, file, 0, 8);
        int at = 16;
        put(file, at, width);
        put(file, at + 4, height);
        file[at + 8] = 8; // bits
        file[at + 9] = (byte) (bytesPerPixel == 4 ? 6 : 2);
        at = chunk(file, 8, "IHDR", 13);
        int data = at + 8;
        file[data] = 0x78; // deflate with a window of 32 kB
        file[data + 1] = 0x01;
        int to = data + 2;
        for (int from = 0; from < rows.length; from += BLOCK) {
            int length = Math.min(BLOCK, rows.length - from);
            file[to] = (byte) (from + length == rows.length ? 1 : 0);
            file[to + 1] = (byte) length;
            file[to + 2] = (byte) (length >> 8);
            file[to + 3] = (byte) ~length;
            file[to + 4] = (byte) (~length >> 8);
            System.arraycopy(rows, from, file, to + 5, length);
            to += 5 + length;
        }
        put(file, to, adler32(rows));
        at = chunk(file, at, "IDAT", to + 4 - data);
        chunk(file, at, "IEND", 0);
        return file;
    }

    /** Each row with its filter, which is none, before it. */
    private byte[] rows(int bytesPerPixel) {
        byte[] rows = new byte[height * (1 + width * bytesPerPixel)];
        int to = 0;
        for (int i = 0; i < argb.length; i++) {
            if (i % width == 0) to++;
            rows[to++] = (byte) (argb[i] >> 16);
            rows[to++] = (byte) (argb[i] >> 8);
            rows[to++] = (byte) argb[i];
            if (bytesPerPixel == 4) rows[to++] = (byte) (argb[i] >> 24);
        }
        return rows;
    }

    /** Completes a chunk whose data are in their place; returns where the next one starts. */
    private static int chunk(byte[] file, int start, String type, int length) {
        put(file, start, length);
        for (int i = 0; i < 4; i++) file[start + 4 + i] = (byte) type.charAt(i);
        CRC32 sum = new CRC32();
        sum.update(file, start + 4, 4 + length);
        put(file, start + 8 + length, (int) sum.getValue());
        return start + 12 + length;
    }

    private static void put(byte[] file, int at, int value) {
        for (int i = 0; i < 4; i++) file[at + i] = (byte) (value >> 24 - 8 * i);
    }

    private static int adler32(byte[] bytes) {
        int a = 1;
        int b = 0;
        for (int i = 0; i < bytes.length; i++) {
            a += bytes[i] & 255;
            b += a;
            if (i % ADLER_RUN == ADLER_RUN - 1 || i == bytes.length - 1) {
                a %= ADLER;
                b %= ADLER;
            }
        }
        return b << 16 | a;
    }
}
