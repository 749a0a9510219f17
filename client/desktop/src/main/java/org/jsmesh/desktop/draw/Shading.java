package org.jsmesh.desktop.draw;

/** What the colours of a picture show. */
public enum Shading {
    /** The materials, in the light of the studio. */
    MATERIALS,
    /** The same with a normal for each face, so that the triangles show. */
    FLAT,
    /** Each face in the colour of its direction as the eye sees it: right is red, up is green, to the eye is blue. */
    NORMALS,
    /** Each face in the colour of the level in which it came. */
    LEVELS,
    /** How far what is shown is from the newest mesh that has arrived. */
    ERROR;

    /** {@return whether colours are those of a scale, and not of the model} */
    public boolean isPainted() {
        return this == LEVELS || this == ERROR;
    }
}
