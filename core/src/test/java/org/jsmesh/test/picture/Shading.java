package org.jsmesh.test.picture;

/** What a surface shows of the light that falls on it. All vectors are unit vectors in eye space. */
public interface Shading {
    /**
     * Adds linear light.
     *
     * @param albedo red, green, blue, linear
     * @param normal turned to the viewer
     * @param worldUp the direction that is up in the model
     * @param toEye from the surface
     * @param to what is added to
     */
    void shade(double[] albedo, double[] normal, double[] worldUp, double[] toEye, double[] to);

    /** {@return red, green, blue, as sRGB, of models without any colour} */
    default double[] uncoloured() {
        return new double[] {.8, .8, .8};
    }
}
