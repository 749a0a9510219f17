package org.jsmesh.mesh.io;

/**
 * Colours for numbers of a colour table that is not in the file: the same number has the same colour everywhere, and
 * numbers that follow each other have colours that differ. The hue goes on by the golden section.
 */
final class ColourTable {
    private static final double STEP = (Math.sqrt(5) - 1) / 2;
    private static final double BRIGHT = .9;
    private static final double DARK = .3;

    private ColourTable() {}

    /** Red, green, blue in 0..1, whole parts of 255. */
    static float[] colour(int number) {
        double hue = 6 * ((number & 0xFFFF) * STEP % 1);
        float[] rgb = new float[3];
        for (int i = 0; i < 3; i++) {
            double distance = Math.abs((hue - 2 * i + 9) % 6 - 3); // 0 at the hue of this component
            double part = Math.max(0, Math.min(1, 2 - distance));
            rgb[i] = Math.round(255 * (DARK + (BRIGHT - DARK) * part)) / 255f;
        }
        return rgb;
    }
}
