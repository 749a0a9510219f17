package org.jsmesh.poster;

/** Brightness and two differences of colour (JFIF 1.02), the latter for each square of four pixels. */
final class Planes {
    private static final int BITS = 16;
    private static final int HALF = 1 << BITS - 1;
    /** Shares of red, green and blue in 65536ths; those of a plane have the sum 65536 or 0. */
    private static final int[][] SHARES = {{19595, 38470, 7471}, {-11059, -21709, 32768}, {32768, -27439, -5329}};

    private Planes() {}

    /**
     * Splits a picture into planes around 0. Beyond its right and lower edge they go on with the pixels there.
     *
     * @param rgb red from the third byte on
     * @param wide width of the first plane, even
     * @param high its height, even
     */
    static int[][] of(int width, int height, int[] rgb, int wide, int high) {
        int[][] planes = {new int[wide * high], new int[wide * high / 4], new int[wide * high / 4]};
        for (int i = 0; i < wide * high; i++) {
            int pixel = rgb[Math.min(height - 1, i / wide) * width + Math.min(width - 1, i % wide)];
            planes[0][i] = (share(pixel, 0) + HALF >> BITS) - 128;
        }
        int half = wide / 2;
        for (int i = 0; i < half * high / 2; i++) {
            for (int plane = 1; plane < 3; plane++) {
                int sum = 0;
                for (int k = 0; k < 4; k++) {
                    int x = Math.min(width - 1, i % half * 2 + k % 2);
                    int y = Math.min(height - 1, i / half * 2 + k / 2);
                    sum += share(rgb[y * width + x], plane);
                }
                planes[plane][i] = Math.min(127, sum + 2 * (1 << BITS) >> BITS + 2);
            }
        }
        return planes;
    }

    private static int share(int pixel, int plane) {
        int sum = 0;
        for (int k = 0; k < 3; k++) sum += SHARES[plane][k] * (pixel >> 16 - 8 * k & 255);
        return sum;
    }
}
