package org.jsmesh.display;

import org.jsmesh.mesh.Channel;

/** Colours as four bytes of a screen: red, green, blue, alpha from the lowest byte on. */
final class PackedColours {
    static final int WHITE = -1;

    private PackedColours() {}

    /**
     * The colour of a wedge that has one.
     *
     * @param full the number that stands for full light, see {@link ColourRange}
     */
    static int of(Channel colour, int wedge, double full) {
        // One component is a shade of grey.
        int green = Math.min(1, colour.components() - 1);
        int blue = Math.min(2, colour.components() - 1);
        boolean linear = colour.isLinearLight();
        int alpha = colour.components() > 3 ? level(colour, wedge, 3, full) : 255;
        return part(colour, wedge, 0, full, linear)
                | part(colour, wedge, green, full, linear) << 8
                | part(colour, wedge, blue, full, linear) << 16
                | alpha << 24;
    }

    private static int part(Channel colour, int wedge, int component, double full, boolean linear) {
        return linear
                ? LinearLight.level(colour.number(wedge, component) / full)
                : level(colour, wedge, component, full);
    }

    private static int level(Channel colour, int wedge, int component, double full) {
        double value = colour.number(wedge, component) / full;
        return value <= 0 ? 0 : value >= 1 ? 255 : (int) (value * 255 + .5);
    }
}
