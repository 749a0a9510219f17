package org.jsmesh.mesh;

/**
 * An image as colours. A viewer shows it in place of a {@link Texture} that has not arrived; an encoder learns from it
 * what a texture shows.
 *
 * @param path of the texture, as materials name it
 * @param width in pixels
 * @param height in pixels
 * @param rgb red × 65536 + green × 256 + blue per pixel, row by row from the top. Shared
 */
public record Picture(String path, int width, int height, int[] rgb) {
    private static final int FILE_HEADER = 14;
    private static final int INFO_HEADER = 40;
    private static final int PLANES_AND_DEPTH = 1 | 24 << 16;

    /**
     * Checks the size.
     *
     * @param path see {@link #path()}
     * @param width see {@link #width()}
     * @param height see {@link #height()}
     * @param rgb see {@link #rgb()}
     * @throws IllegalArgumentException when there are not width × height colours
     */
    public Picture {
        if (width < 1 || height < 1 || rgb.length != (long) width * height)
            throw new IllegalArgumentException(rgb.length + " colours for " + width + " x " + height);
    }

    /** {@return the picture as a file in the BMP format, which browsers and Java read} */
    public byte[] bmp() {
        int row = (3 * width + 3) & -4;
        byte[] file = new byte[FILE_HEADER + INFO_HEADER + row * height];
        file[0] = 'B';
        file[1] = 'M';
        put(file, 2, file.length);
        put(file, 10, FILE_HEADER + INFO_HEADER);
        put(file, 14, INFO_HEADER);
        put(file, 18, width);
        put(file, 22, height); // positive: the last row comes first
        put(file, 26, PLANES_AND_DEPTH);
        put(file, 34, row * height);
        for (int y = 0; y < height; y++) {
            int at = FILE_HEADER + INFO_HEADER + (height - 1 - y) * row;
            for (int x = 0; x < width; x++, at += 3) {
                int colour = rgb[y * width + x];
                file[at] = (byte) colour;
                file[at + 1] = (byte) (colour >> 8);
                file[at + 2] = (byte) (colour >> 16);
            }
        }
        return file;
    }

    private static void put(byte[] file, int at, int value) {
        for (int i = 0; i < 4; i++) file[at + i] = (byte) (value >> 8 * i);
    }
}
