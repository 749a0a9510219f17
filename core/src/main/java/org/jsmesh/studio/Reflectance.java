package org.jsmesh.studio;

/**
 * How much of the light from all sides a rough surface reflects (Karis 2013, "Real shading in Unreal Engine 4"): with
 * the reflectance f from straight ahead and 1 from the side it is f · scale + bias. Surfaces follow Trowbridge and
 * Reitz, with Smith's shadowing where heights are correlated (Heitz 2014).
 */
public final class Reflectance {
    /** Entries a side. */
    public static final int SIDE = 32;

    private static final int SAMPLES = 128;
    private static final double TWO_TO_32 = 4294967296.0;

    private Reflectance() {}

    /**
     * Computes the table.
     *
     * @return scale and bias of each entry: roughness grows along rows, the cosine of the angle between normal and eye
     *     from row to row, both from 1/64 to 63/64
     */
    public static float[] table() {
        float[] table = new float[2 * SIDE * SIDE];
        for (int i = 0; i < SIDE * SIDE; i++) {
            double roughness = (i % SIDE + .5) / SIDE;
            int row = i / SIDE;
            double[] entry = entry((row + .5) / SIDE, roughness * roughness);
            table[2 * i] = (float) entry[0];
            table[2 * i + 1] = (float) entry[1];
        }
        return table;
    }

    /** Over normals that the eye sees (Heitz 2018), at Hammersley's points. */
    private static double[] entry(double cosine, double alpha) {
        double sine = Math.sqrt(1 - cosine * cosine);
        double square = alpha * alpha;
        double length = StrictMath.hypot(alpha * sine, cosine);
        double vx = alpha * sine / length;
        double vz = cosine / length;
        double eyeSide = Math.sqrt(square + (1 - square) * cosine * cosine);
        double scale = 0;
        double bias = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double radius = Math.sqrt((i + .5) / SAMPLES);
            double around = 2 * Math.PI * ((Integer.toUnsignedLong(Integer.reverse(i)) + .5) / TWO_TO_32);
            double right = radius * StrictMath.cos(around);
            double up = (1 - vz) / 2 * Math.sqrt(1 - right * right) + (1 + vz) / 2 * radius * StrictMath.sin(around);
            double out = Math.sqrt(Math.max(0, 1 - right * right - up * up));
            double nx = alpha * (out * vx - up * vz);
            double ny = alpha * right;
            double nz = Math.max(0, out * vz + up * vx);
            double norm = Math.sqrt(nx * nx + ny * ny + nz * nz);
            double toEye = (sine * nx + cosine * nz) / norm;
            double toLight = 2 * toEye * nz / norm - cosine;
            if (toLight <= 0) continue;
            double lightSide = Math.sqrt(square + (1 - square) * toLight * toLight);
            double visible = toLight * (cosine + eyeSide) / (toLight * eyeSide + cosine * lightSide);
            double fresnel = StrictMath.pow(1 - toEye, 5);
            scale += (1 - fresnel) * visible;
            bias += fresnel * visible;
        }
        return new double[] {scale / SAMPLES, bias / SAMPLES};
    }
}
