package org.jsmesh.samples;

/** Colours as three parts from 0 to 1. */
final class Colour {
    private Colour() {}

    static double[] rgb(int hex) {
        return new double[] {(hex >> 16) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0};
    }

    static double[] mix(double[] a, double[] b, double t) {
        return new double[] {Blend.mix(a[0], b[0], t), Blend.mix(a[1], b[1], t), Blend.mix(a[2], b[2], t)};
    }
}
