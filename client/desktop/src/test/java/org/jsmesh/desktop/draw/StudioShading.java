package org.jsmesh.desktop.draw;

import org.jsmesh.studio.Lighting;
import org.jsmesh.studio.Reflectance;
import org.jsmesh.studio.Studio;
import org.jsmesh.test.picture.Shading;

/**
 * The shader's formula written down once more, for surfaces without images that are no metal and of plain roughness.
 */
final class StudioShading implements Shading {
    private static final float[] LIGHT = Studio.light();
    private static final float[] REFLECTANCES = Reflectance.table();
    private static final double ROUGHNESS = Lighting.PLAIN_ROUGHNESS;
    private static final double REFLECTANCE = .04;

    /** Of the roughness .62, between .4 for the level 5 and .8 for the level 8; that of matte surfaces is the last. */
    private static final double LEVEL = 5 + (ROUGHNESS - .4) / .4 * 3;

    @Override
    public void shade(double[] albedo, double[] normal, double[] worldUp, double[] toEye, double[] to) {
        double[] key = doubles(Lighting.KEY_DIRECTION);
        double[] half = new double[3];
        for (int k = 0; k < 3; k++) half[k] = key[k] + toEye[k];
        double length = Math.sqrt(dot(half, half));
        for (int k = 0; k < 3; k++) half[k] /= length;
        double eye = Math.max(0, dot(normal, toEye));
        double lamp = Math.max(0, dot(normal, key));
        double gloss = gloss(lamp, eye, Math.max(0, dot(normal, half)), dot(toEye, half));
        double[] share = share(eye);
        double once = REFLECTANCE * share[0] + share[1];
        double lost = 1 - share[0] - share[1];
        double mean = REFLECTANCE + (1 - REFLECTANCE) / 21;
        double again = once * mean / (1 - lost * mean) * lost;
        double around = studio(normal, worldUp, Studio.LEVELS - 1);
        double[] mirror = new double[3];
        double blend = Math.pow(ROUGHNESS, 4);
        for (int k = 0; k < 3; k++)
            mirror[k] = (1 - blend) * (2 * dot(normal, toEye) * normal[k] - toEye[k]) + blend * normal[k];
        double[] seen = new double[3];
        for (int k = 0; k < 3; k++) {
            double above = .5 + .5 * dot(normal, worldUp);
            double sky = Lighting.GROUND[k] + above * (Lighting.SKY[k] - Lighting.GROUND[k]);
            seen[k] = Lighting.KEY[k] * lamp * (albedo[k] / Math.PI + gloss)
                    + albedo[k] * (sky / Math.PI + (1 - once - again) * around)
                    + once * studio(mirror, worldUp, LEVEL)
                    + again * around;
        }
        double[] toned = toned(seen);
        for (int k = 0; k < 3; k++) to[k] += toned[k];
    }

    @Override
    public double[] uncoloured() {
        return new double[] {.74, .71, .66};
    }

    private static double gloss(double lamp, double eye, double tilt, double middle) {
        double square = Math.pow(ROUGHNESS, 4);
        double spread = tilt * tilt * (square - 1) + 1;
        double hidden = lamp * Math.sqrt(square + (1 - square) * eye * eye)
                + eye * Math.sqrt(square + (1 - square) * lamp * lamp);
        double fresnel = REFLECTANCE + (1 - REFLECTANCE) * Math.pow(1 - middle, 5);
        return fresnel * square / (Math.PI * spread * spread) / 2 / Math.max(hidden, 1e-6);
    }

    /** The Khronos PBR Neutral tone mapper. */
    static double[] toned(double[] light) {
        double[] c = new double[3];
        for (int k = 0; k < 3; k++) c[k] = Lighting.EXPOSURE * light[k];
        double least = Math.min(c[0], Math.min(c[1], c[2]));
        for (int k = 0; k < 3; k++) c[k] -= least < .08 ? least - 6.25 * least * least : .04;
        double peak = Math.max(c[0], Math.max(c[1], c[2]));
        if (peak < .76) return c;
        double lower = 1 - .24 * .24 / (peak + .24 - .76);
        double kept = 1 / (.15 * (peak - lower) + 1);
        for (int k = 0; k < 3; k++) c[k] = lower + kept * (c[k] * lower / peak - lower);
        return c;
    }

    /** The entries of the table around a cosine, at the roughness. */
    private static double[] share(double cosine) {
        double[] share = new double[2];
        for (int row = 0; row < 2; row++) {
            for (int column = 0; column < 2; column++) {
                double x = ROUGHNESS * Reflectance.SIDE - .5;
                double y = cosine * Reflectance.SIDE - .5;
                int i = Math.max(0, Math.min(Reflectance.SIDE - 1, (int) Math.floor(x) + column));
                int j = Math.max(0, Math.min(Reflectance.SIDE - 1, (int) Math.floor(y) + row));
                double wx = column == 0 ? 1 - (x - Math.floor(x)) : x - Math.floor(x);
                double wy = row == 0 ? 1 - (y - Math.floor(y)) : y - Math.floor(y);
                for (int k = 0; k < 2; k++) share[k] += wx * wy * REFLECTANCES[2 * (j * Reflectance.SIDE + i) + k];
            }
        }
        return share;
    }

    /** Of the nearest pixel; the camera of the tests looks down, so that up is never towards the viewer. */
    private static double studio(double[] direction, double[] worldUp, double level) {
        double[] d = toWorld(direction, worldUp);
        double sum = Math.abs(d[0]) + Math.abs(d[1]) + Math.abs(d[2]);
        double x = d[0] / sum;
        double z = d[2] / sum;
        if (d[1] < 0) {
            double folded = (1 - Math.abs(z)) * (x < 0 ? -1 : 1);
            z = (1 - Math.abs(x)) * (z < 0 ? -1 : 1);
            x = folded;
        }
        int inner = Studio.SIDE - 2;
        int column = 1 + (int) Math.min(inner - 1, (x + 1) / 2 * inner);
        int row = 1 + (int) Math.min(inner - 1, (z + 1) / 2 * inner);
        int below = (int) Math.floor(level);
        int above = Math.min(Studio.LEVELS - 1, below + 1);
        double part = level - below;
        int at = row * Studio.SIDE + column;
        int all = Studio.SIDE * Studio.SIDE;
        return Lighting.STUDIO * ((1 - part) * LIGHT[below * all + at] + part * LIGHT[above * all + at]);
    }

    /** From eye space, for a camera that is turned by the yaw of the tests and does not lean to a side. */
    private static double[] toWorld(double[] v, double[] worldUp) {
        double sin = Math.sin(Math.toRadians(30));
        double cos = Math.cos(Math.toRadians(30));
        double back = worldUp[1] * v[2] - worldUp[2] * v[1];
        return new double[] {cos * v[0] + sin * back, dot(v, worldUp), -sin * v[0] + cos * back};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] doubles(float[] values) {
        double[] d = new double[values.length];
        for (int i = 0; i < d.length; i++) d[i] = values[i];
        return d;
    }
}
