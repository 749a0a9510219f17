package org.jsmesh.collapse;

/** How much time a simplification may take for the shape of the levels of detail. */
public enum Effort {
    LITTLE,
    SOME,

    /** Costs are distances measured at points of the original. */
    MUCH
}
