package org.jsmesh.display;

/** What an image is for in a material. */
public enum Slot {
    /** Colour, and opacity in its alpha where the material says so. */
    COLOUR,
    /** How metallic the surface is. */
    METALLIC,
    /** How rough the surface is. */
    ROUGHNESS,
    /** Normals in the space of the surface: x to the right of the image, y to its top. */
    NORMAL,
    /** Height of the surface, from black to white. */
    BUMP,
    /** Share of the light from all around that reaches the surface. */
    OCCLUSION,
    /** Light that the surface sends out. */
    EMISSION,
    /** Opacity apart from that of the colour: alpha, or brightness where the image has none. */
    OPACITY
}
