package org.jsmesh.samples;

/**
 * An eye of the octopus: a ball whose rings lie close together in front, where the golden iris is, and the bar that is
 * an octopus's pupil.
 */
final class Eye {
    /** Where the left eye looks, of length 1; the right eye's is mirrored. */
    static final double[] AXIS = {0.70, 0.14, 0.70};

    private static final int SECTORS = 64;
    private static final int RINGS = 32;

    private Eye() {}

    static void addTo(PlyBytes ply, double[] centre, double radius, int side) {
        double[] ahead = {side * AXIS[0], AXIS[1], AXIS[2]};
        double length = StrictMath.sqrt(ahead[0] * ahead[0] + ahead[1] * ahead[1] + ahead[2] * ahead[2]);
        double flat = StrictMath.sqrt(ahead[0] * ahead[0] + ahead[2] * ahead[2]);
        double[] across = {ahead[2] / flat, 0, -ahead[0] / flat};
        for (int a = 0; a < 3; a++) ahead[a] /= length;
        double[] up = {
            ahead[1] * across[2] - ahead[2] * across[1],
            ahead[2] * across[0] - ahead[0] * across[2],
            ahead[0] * across[1] - ahead[1] * across[0]
        };
        int vertices = 2 + (RINGS - 1) * SECTORS;
        double[] positions = new double[3 * vertices];
        byte[] colours = new byte[3 * vertices];
        for (int v = 0; v < vertices; v++) {
            int ring = v == 0 ? 0 : 1 + (v - 1) / SECTORS;
            double t = (double) ring / RINGS;
            double polar = StrictMath.PI * (0.55 * t + 0.45 * t * t * t);
            double turn = 2 * StrictMath.PI * ((v + SECTORS - 1) % SECTORS) / SECTORS;
            double c = StrictMath.cos(polar);
            double s = StrictMath.sin(polar);
            double i = s * StrictMath.cos(turn);
            double j = s * StrictMath.sin(turn);
            double[] rgb = colour(polar, i, j);
            for (int a = 0; a < 3; a++) {
                double out = 0.93 * (c * ahead[a] + i * across[a] + j * up[a]) + 0.16 * ahead[a];
                positions[3 * v + a] = (a == 0 ? side : 1) * centre[a] + radius * out;
                colours[3 * v + a] = (byte) StrictMath.rint(255 * rgb[a]);
            }
        }
        ply.add(positions, colours, triangles(vertices));
    }

    private static int[] triangles(int vertices) {
        int[] triangles = new int[6 * SECTORS * (RINGS - 1)];
        int n = 0;
        for (int s = 0; s < SECTORS; s++) {
            int next = (s + 1) % SECTORS;
            n = put(triangles, n, 0, 1 + s, 1 + next);
            for (int ring = 1; ring < RINGS - 1; ring++) {
                int inner = 1 + (ring - 1) * SECTORS;
                int outer = inner + SECTORS;
                n = put(triangles, n, inner + s, outer + s, outer + next);
                n = put(triangles, n, inner + s, outer + next, inner + next);
            }
            int last = 1 + (RINGS - 2) * SECTORS;
            n = put(triangles, n, last + s, vertices - 1, last + next);
        }
        return triangles;
    }

    private static int put(int[] triangles, int n, int a, int b, int c) {
        triangles[n] = a;
        triangles[n + 1] = b;
        triangles[n + 2] = c;
        return n + 3;
    }

    private static double[] colour(double polar, double across, double up) {
        double[] iris = Colour.mix(Colour.rgb(0xF7D774), Colour.rgb(0xC98A2B), Blend.ramp(0.25, 0.72, polar));
        double[] colour = Colour.mix(iris, Colour.rgb(0x4A1D17), Blend.ramp(0.68, 0.76, polar));
        double bar = StrictMath.sqrt(fourth(up / 0.17) + fourth(across / 0.47));
        return Colour.mix(Colour.rgb(0x120709), colour, Blend.ramp(0.8, 1.2, bar));
    }

    private static double fourth(double x) {
        return x * x * x * x;
    }
}
