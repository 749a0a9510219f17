package org.jsmesh.test.picture;

/**
 * A hemisphere light and two directional lights, in linear light (0 to 1 and more). A surface with albedo a and normal
 * n, turned to the viewer, shows {@code a · (mix(ground, sky, (1 + n·up) / 2) + key · max(n·k, 0) + fill · max(n·f, 0))
 * + highlight · key · max(n·h, 0)^shininess}; k and f are directions in eye space (x right, y up, z towards the
 * viewer), up is +y of the model, h is halfway between k and the direction to the eye.
 */
public record Light(
        double[] sky,
        double[] ground,
        double[] key,
        double[] keyDirection,
        double[] fill,
        double[] fillDirection,
        double highlight,
        double shininess)
        implements Shading {
    /** The same white light from everywhere: albedo as it is. */
    public static final Light FLAT = new Light(
            new double[] {1, 1, 1},
            new double[] {1, 1, 1},
            new double[3],
            new double[] {0, 0, 1},
            new double[3],
            new double[] {0, 0, 1},
            0,
            1);

    @Override
    public void shade(double[] albedo, double[] normal, double[] worldUp, double[] toEye, double[] to) {
        double above = .5 + .5 * Vectors.dot(normal, worldUp);
        double fromKey = Math.max(0, Vectors.dot(normal, Vectors.unit(keyDirection)));
        double fromFill = Math.max(0, Vectors.dot(normal, Vectors.unit(fillDirection)));
        double[] k = Vectors.unit(keyDirection);
        double[] half = Vectors.unit(new double[] {k[0] + toEye[0], k[1] + toEye[1], k[2] + toEye[2]});
        double shine = highlight * Math.pow(Math.max(0, Vectors.dot(normal, half)), shininess);
        for (int c = 0; c < 3; c++) {
            double light = ground[c] + above * (sky[c] - ground[c]) + key[c] * fromKey + fill[c] * fromFill;
            to[c] += albedo[c] * light + shine * key[c];
        }
    }
}
