package org.jsmesh.poster;

import org.jsmesh.studio.Lighting;
import org.jsmesh.studio.Reflectance;
import org.jsmesh.studio.Studio;

/** Looks up the tables of the studio, between their entries, as a graphics card does. */
final class StudioLight {
    private static final int AREA = Studio.SIDE * Studio.SIDE;
    private static final int MATTE = Studio.LEVELS - 1;

    private final float[] light;
    private final float[] reflectances;

    private StudioLight(float[] light, float[] reflectances) {
        this.light = light;
        this.reflectances = reflectances;
    }

    /** The tables, which are computed when the first poster is drawn. */
    static StudioLight get() {
        return Kept.LIGHT;
    }

    private static final class Kept {
        static final StudioLight LIGHT = new StudioLight(Studio.light(), Reflectance.table());
    }

    /** Light that a matte surface of this normal gets. */
    double matte(double x, double y, double z) {
        return at(x, y, z, MATTE, MATTE, 0);
    }

    /** Light that a surface of a roughness mirrors from a direction of length 1. */
    double mirrored(double x, double y, double z, double rough) {
        double blur = blur(rough);
        int level = (int) blur;
        return at(x, y, z, level, Math.min(MATTE, level + 1), blur - level);
    }

    private double at(double x, double y, double z, int level, int next, double part) {
        double sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
        double a = x / sum;
        double b = z / sum;
        if (y < 0) {
            double folded = (1 - Math.abs(b)) * (a < 0 ? -1 : 1);
            b = (1 - Math.abs(a)) * (b < 0 ? -1 : 1);
            a = folded;
        }
        double across = 1 + (a + 1) / 2 * (Studio.SIDE - 2) - .5;
        double along = 1 + (b + 1) / 2 * (Studio.SIDE - 2) - .5;
        int column = Math.min((int) across, Studio.SIDE - 2);
        int row = Math.min((int) along, Studio.SIDE - 2);
        double right = across - column;
        double below = along - row;
        int from = row * Studio.SIDE + column;
        double near = bilinear(light, level * AREA + from, 1, Studio.SIDE, right, below);
        if (part == 0) return Lighting.STUDIO * near;
        double far = bilinear(light, next * AREA + from, 1, Studio.SIDE, right, below);
        return Lighting.STUDIO * (near + part * (far - near));
    }

    private static double bilinear(float[] table, int from, int stride, int row, double right, double below) {
        double above = table[from] + right * (table[from + stride] - table[from]);
        double under = table[from + row] + right * (table[from + row + stride] - table[from + row]);
        return above + below * (under - above);
    }

    /** The level of the studio that a roughness mirrors, as in three.js. */
    private static double blur(double rough) {
        if (rough < .21) return Math.max(0, Math.min(3, 7 + 2 * StrictMath.log(1.16 * rough) / StrictMath.log(2)));
        if (rough < .305) return 3 + (rough - .21) / .095;
        if (rough < .4) return 4 + (rough - .305) / .095;
        if (rough < .8) return 5 + (rough - .4) / .4 * 3;
        return 8 + (Math.min(1, rough) - .8) / .2;
    }

    /** Scale (k = 0) or bias (k = 1) of what a surface reflects of the light from all sides. */
    double reflected(double cosine, double rough, int k) {
        double most = Reflectance.SIDE - 1;
        double across = Math.max(0, Math.min(most, rough * Reflectance.SIDE - .5));
        double along = Math.max(0, Math.min(most, cosine * Reflectance.SIDE - .5));
        int column = Math.min((int) across, Reflectance.SIDE - 2);
        int row = Math.min((int) along, Reflectance.SIDE - 2);
        int from = 2 * (row * Reflectance.SIDE + column) + k;
        return bilinear(reflectances, from, 2, 2 * Reflectance.SIDE, across - column, along - row);
    }
}
