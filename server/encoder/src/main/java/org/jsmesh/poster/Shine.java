package org.jsmesh.poster;

import org.jsmesh.studio.Lighting;

/**
 * The light that a surface sends to the eye after the model of glTF 2.0 (appendix B): a matte part and a glossy one
 * after Trowbridge and Reitz, under the light that {@link Lighting} describes. Terms and constants are those of
 * three.js 0.181, so that page, window and poster look alike. The values of a place are set first. Used by one thread.
 */
final class Shine {
    private static final double SMOOTHEST = .0525;
    private static final double COAT = .04;

    private final StudioLight studio = StudioLight.get();
    private final double[] key;

    /** Colour in linear light, and the numbers of the surface. */
    final double[] albedo = new double[3];

    double metal;
    double rough;
    double bend; // how much the normal changes from pixel to pixel
    double open; // share of the light from all sides that gets there
    final double[] toEye = new double[3];
    final double[] normal = new double[3]; // with the bumps of an image
    final double[] plain = new double[3]; // without

    private final double[] f0 = new double[3];

    Shine(View view) {
        key = new double[3];
        for (int k = 0; k < 3; k++)
            key[k] = Lighting.KEY_DIRECTION[0] * view.right[k]
                    + Lighting.KEY_DIRECTION[1] * view.up[k]
                    + Lighting.KEY_DIRECTION[2] * view.back[k];
    }

    /** Adds the light to red, green, blue. */
    void light(Surface surface, double[] rgb) {
        double r = Math.min(Math.max(rough, SMOOTHEST) + bend, 1);
        for (int k = 0; k < 3; k++) f0[k] = mix(surface.reflectance[k], albedo[k], metal);
        double f90 = mix(surface.reflectance[3], 1, metal);
        double lamp = positive(View.dot(normal, key));
        double cosine = positive(View.dot(normal, toEye));
        double scale = studio.reflected(cosine, r, 0);
        double bias = studio.reflected(cosine, r, 1);
        double lampScale = studio.reflected(lamp, r, 0);
        double lampBias = studio.reflected(lamp, r, 1);
        double lost = 1 - scale - bias;
        double gloss = lobe(normal, lamp, cosine, r);
        double fresnel = fresnel(toHalf(toEye));
        double around = studio.matte(normal[0], normal[1], normal[2]);
        double mirrored = mirrored(normal, r);
        double above = .5 + .5 * normal[1];
        double clear = clear(cosine, r);
        double most = 0;
        for (int k = 0; k < 3; k++) {
            double mean = f0[k] + (1 - f0[k]) / 21;
            double once = f0[k] * scale + f90 * bias;
            most = Math.max(most, once + once * mean / (1 - lost * mean) * lost);
        }
        for (int k = 0; k < 3; k++) {
            double mean = f0[k] + (1 - f0[k]) / 21;
            double once = f0[k] * scale + f90 * bias;
            double again = once * mean / (1 - lost * mean) * lost;
            double matte = albedo[k] * (1 - metal);
            double twice = lost * (1 - lampScale - lampBias);
            double glossAgain =
                    once * (f0[k] * lampScale + f90 * lampBias) * mean * twice / (1 - twice * mean * mean + 1e-6);
            double direct = Lighting.KEY[k] * lamp * (matte / Math.PI + mix(f0[k], f90, fresnel) * gloss + glossAgain);
            double sky = mix(Lighting.GROUND[k], Lighting.SKY[k], above);
            double diffuse = matte * sky / Math.PI + matte * (1 - most) * around;
            rgb[k] += direct + open * diffuse + clear * (mirrored * once + around * again);
        }
        if (surface.coat > 0) coat(surface, rgb);
    }

    private void coat(Surface surface, double[] rgb) {
        double c = Math.min(Math.max(surface.coatRoughness, SMOOTHEST) + bend, 1);
        double lamp = positive(View.dot(plain, key));
        double cosine = positive(View.dot(plain, toEye));
        double thin = COAT * studio.reflected(cosine, c, 0) + studio.reflected(cosine, c, 1);
        double gloss = lobe(plain, lamp, cosine, c) * mix(COAT, 1, fresnel(toHalf(toEye)));
        double mirrored = open * mirrored(plain, c) * thin;
        double hidden = surface.coat * mix(COAT, 1, fresnel(cosine));
        for (int k = 0; k < 3; k++)
            rgb[k] = rgb[k] * (1 - hidden) + surface.coat * (Lighting.KEY[k] * lamp * gloss + mirrored);
    }

    /** Cosine between the eye and the direction halfway between eye and key lamp. */
    private double toHalf(double[] eye) {
        return Math.sqrt(Math.max(0, (1 + View.dot(eye, key)) / 2));
    }

    /** Of the key lamp's light, without the Fresnel term: Smith's shadowing with correlated heights (Heitz 2014). */
    private double lobe(double[] n, double lamp, double eye, double r) {
        double square = r * r * r * r;
        double half = Math.sqrt(Math.max(1e-12, 2 + 2 * View.dot(toEye, key)));
        double tilt = Math.min(1, positive((View.dot(n, key) + View.dot(n, toEye)) / half));
        double spread = tilt * tilt * (square - 1) + 1;
        double hidden = lamp * Math.sqrt(square + (1 - square) * eye * eye)
                + eye * Math.sqrt(square + (1 - square) * lamp * lamp);
        return square / (Math.PI * spread * spread) * .5 / Math.max(hidden, 1e-6);
    }

    private double mirrored(double[] n, double r) {
        double facing = 2 * View.dot(n, toEye);
        double part = r * r * r * r;
        double x = mix(facing * n[0] - toEye[0], n[0], part);
        double y = mix(facing * n[1] - toEye[1], n[1], part);
        double z = mix(facing * n[2] - toEye[2], n[2], part);
        return studio.mirrored(x, y, z, r);
    }

    /** Share of the mirrored light that is not shadowed. */
    private double clear(double cosine, double r) {
        if (open == 1) return 1;
        double power = StrictMath.pow(2, -16 * r - 1);
        return Math.max(0, Math.min(1, StrictMath.pow(cosine + open, power) - 1 + open));
    }

    private static double fresnel(double cosine) {
        double x = 1 - Math.min(1, cosine);
        return x * x * x * x * x;
    }

    private static double positive(double x) {
        return Math.max(0, Math.min(1, x));
    }

    private static double mix(double a, double b, double part) {
        return a + part * (b - a);
    }
}
