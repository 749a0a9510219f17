package org.jsmesh.samples;

/**
 * The painting of the amphora, in the manner of the Greek geometric period: bands of black slip on red clay. A painting
 * says for each place how much slip lies there (0 to 1), how red it is, and how the clay is tinted.
 */
final class AmphoraPainting {
    static final int WIDTH = 2048;
    static final int HEIGHT = 1280;

    /** Below this row (as texture coordinate v) lie handles and inside, above it the outer wall. */
    static final double WALL_FROM = 0.14;

    private static final int SHADES = 14;
    private static final int TINTS = 9;
    private static final int[] CLAY = {0xB9622F, 0xDD8B4C};
    private static final int[] SLIP = {0x1A1413, 0x2E2523};
    private static final int[] RED = {0x6E1F17, 0x8A2C20};

    /** In heights of the band. */
    private static final double CIRCLE_SPACING = 1.04;

    private static final double CIRCLE_RADIUS = 0.43;

    private AmphoraPainting() {}

    static byte[] png() {
        byte[] pixels = new byte[WIDTH * HEIGHT];
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) pixels[y * WIDTH + x] = (byte) pixel(x, HEIGHT - 1 - y);
        }
        return PngBytes.write(WIDTH, HEIGHT, palette(), pixels);
    }

    /** Clay to black in some shades, then clay to red in some, each in all tints. */
    private static int[] palette() {
        int[] palette = new int[(SHADES + SHADES / 2) * TINTS];
        for (int i = 0; i < palette.length; i++) {
            int shade = i / TINTS;
            double tint = i % TINTS / (TINTS - 1.0);
            boolean red = shade >= SHADES;
            double cover = red ? (shade - SHADES + 1) / (SHADES / 2.0) : shade / (SHADES - 1.0);
            double[] paint = between(red ? RED : SLIP, tint);
            double[] rgb = Colour.mix(between(CLAY, tint), paint, cover);
            for (int c = 0; c < 3; c++) palette[i] = palette[i] << 8 | (int) StrictMath.rint(255 * rgb[c]);
        }
        return palette;
    }

    private static double[] between(int[] colours, double t) {
        return Colour.mix(Colour.rgb(colours[0]), Colour.rgb(colours[1]), t);
    }

    private static int pixel(int x, int y) {
        double black = 0;
        double red = 0;
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < 3; i++) {
                double u = (x + (i + 0.5) / 3) / WIDTH;
                double v = (y + (j + 0.5) / 3) / HEIGHT;
                int paint = v < WALL_FROM ? 1 : wall(u, (v - WALL_FROM) / (1 - WALL_FROM));
                if (paint == 1) black += 1 / 9.0;
                if (paint == 2) red += 1 / 9.0;
            }
        }
        // The noise goes around: it is taken on a circle.
        double turn = 2 * StrictMath.PI * (x + 0.5) / WIDTH;
        double cx = StrictMath.cos(turn);
        double cz = StrictMath.sin(turn);
        double cy = 6.0 * y / HEIGHT;
        double cloud = 0.8 * Blend.noise(1.3 * cx, 1.3 * cy, 1.3 * cz) + 0.5 * Blend.noise(4 * cx + 7, 9 * cy, 4 * cz);
        int tint = (int) StrictMath.rint((TINTS - 1) * StrictMath.max(0, StrictMath.min(1, 0.55 + 0.6 * cloud)));
        int shade = red > black
                ? SHADES - 1 + (int) StrictMath.max(1, StrictMath.rint(red * (SHADES / 2)))
                : (int) StrictMath.rint((SHADES - 1) * (black + red));
        return shade * TINTS + tint;
    }

    /** @param s up the wall: 0 at the foot, 1 inside the lip. 0 for bare clay, 1 for black, 2 for red */
    private static int wall(double u, double s) {
        if (s < 0.045) return 1;
        if (s < 0.052) return 0;
        if (s < 0.092) return 1;
        if (s < 0.205) return rays(u * 26, (s - 0.092) / 0.113);
        if (s < 0.300) return stripes((s - 0.205) / 0.095, 0b1101111111110110L);
        if (s < 0.318) return 0;
        if (s < 0.362) return runningDog(u * 30, (s - 0.318) / 0.044);
        if (s < 0.380) return 0;
        if (s < 0.412) return stripes((s - 0.380) / 0.032, 0b101110101L);
        if (s < 0.556) return circles(u * 11, (s - 0.412) / 0.144);
        if (s < 0.588) return stripes((s - 0.556) / 0.032, 0b101110101L);
        if (s < 0.602) return 0;
        if (s < 0.668) return meander(u * 18, (s - 0.602) / 0.066);
        if (s < 0.682) return 0;
        if (s < 0.702) return stripes((s - 0.682) / 0.020, 0b10101L);
        if (s < 0.760) return tongues(u * 36, (s - 0.702) / 0.058);
        if (s < 0.776) return 1;
        if (s < 0.783) return 0;
        if (s < 0.789) return 1;
        if (s < 0.800) return 0;
        if (s < 0.868) return lozenges(u * 14, (s - 0.800) / 0.068);
        if (s < 0.880) return 0;
        if (s < 0.886) return 1;
        if (s < 0.893) return 0;
        return 1;
    }

    /** Stripes across the band, one bit each from the bottom; the middle one of those in a broad black field is red. */
    private static int stripes(double t, long pattern) {
        int count = 64 - Long.numberOfLeadingZeros(pattern);
        int stripe = (int) (t * count);
        boolean middle = count == 16 ? stripe == 8 : count == 9 && stripe == 4;
        if (middle) return 2;
        return (int) (pattern >> stripe & 1);
    }

    private static int rays(double x, double t) {
        double across = StrictMath.abs(x - StrictMath.floor(x) - 0.5);
        return across < 0.40 * (1 - t) || t < 0.04 ? 1 : 0;
    }

    /** Waves that chase each other: a spiral per unit, rising from a ground line. */
    private static int runningDog(double x, double t) {
        double px = (x - StrictMath.floor(x) - 0.5) / 0.40;
        double py = (t - 0.56) / 0.44;
        double radius = StrictMath.sqrt(px * px + py * py);
        if (t < 0.2 || radius < 0.14) return 1;
        if (radius >= 1) return 0;
        double arm = radius * 1.55 + StrictMath.atan2(py, px) / (2 * StrictMath.PI);
        return arm - StrictMath.floor(arm) < 0.5 ? 1 : 0;
    }

    /** Sets of concentric circles drawn with a compass, joined by slanting tangents. */
    private static int circles(double x, double t) {
        double fx = (x - StrictMath.floor(x) - 0.5) * CIRCLE_SPACING;
        double fy = t - 0.5;
        double radius = StrictMath.sqrt(fx * fx + fy * fy) / CIRCLE_RADIUS;
        if (radius < 0.17) return 2;
        double ring = radius * 5.9;
        if (radius < 1.0) return ring - StrictMath.floor(ring) < 0.42 ? 1 : 0;
        return tangents(fx - 0.5 * CIRCLE_SPACING, fy) || tangents(fx + 0.5 * CIRCLE_SPACING, fy) ? 1 : 0;
    }

    /** Three lines through the middle between two circles, the central one touching both. */
    private static boolean tangents(double x, double y) {
        double c = 2 * CIRCLE_RADIUS / CIRCLE_SPACING;
        double s = StrictMath.sqrt(1 - c * c);
        double across = StrictMath.abs(c * x + s * y) / 0.022;
        double along = StrictMath.abs(c * y - s * x);
        if (along > 0.5 * CIRCLE_SPACING * s + 0.05) return false;
        return across < 0.55 || StrictMath.abs(across - 2) < 0.5;
    }

    /** The Greek key, on a grid of 8 by 7. */
    private static int meander(double x, double t) {
        String[] rows = {
            "########", //
            "#.......",
            "#.#####.",
            "#.#...#.",
            "#.###.#.",
            "#.....#.",
            "#######.",
        };
        int column = (int) ((x - StrictMath.floor(x)) * 8);
        int row = (int) ((1 - t) * 9) - 1;
        if (row < 0 || row > 6) return row < -5 ? 1 : 0;
        return rows[row].charAt(column) == '#' ? 1 : 0;
    }

    private static int tongues(double x, double t) {
        int number = (int) StrictMath.floor(x);
        double px = StrictMath.abs(x - number - 0.5) / 0.36;
        if (t > 0.94) return 1;
        double py = t < 0.4 ? (0.4 - t) / 0.36 : 0;
        double radius = px * px + py * py;
        if (radius > 1) return 0;
        return number % 3 == 0 ? 2 : 1;
    }

    /** A chain of lozenges, each with a smaller one and a dot inside. */
    private static int lozenges(double x, double t) {
        double size = StrictMath.abs(x - StrictMath.floor(x) - 0.5) * 2 + StrictMath.abs(t - 0.5) * 2.1;
        if (size < 0.18) return 2;
        if (size < 0.36) return 0;
        if (size < 0.66) return 1;
        if (size < 0.86) return 0;
        if (size < 1.04) return 1;
        if (size < 1.26) return 0;
        return size < 1.5 ? 1 : 0;
    }
}
