package org.jsmesh.desktop.draw;

/**
 * How a scene is drawn.
 *
 * @param shading what the colours show
 * @param wireframe whether the edges of the triangles that are seen are drawn over them
 */
public record DrawStyle(Shading shading, boolean wireframe) {
    private static final DrawStyle DEFAULTS = new DrawStyle(Shading.MATERIALS, false);

    /** {@return materials without edges} */
    public static DrawStyle defaults() {
        return DEFAULTS;
    }

    /** {@return the same with other colours} */
    public DrawStyle withShading(Shading other) {
        return new DrawStyle(other, wireframe);
    }

    /** {@return the same with or without edges} */
    public DrawStyle withWireframe(boolean on) {
        return new DrawStyle(shading, on);
    }
}
