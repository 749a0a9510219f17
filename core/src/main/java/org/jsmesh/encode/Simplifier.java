package org.jsmesh.encode;

/** Ways to choose the collapses that lead from the original to the base mesh. */
public enum Simplifier {
    /** The least distance at any number of faces: {@link org.jsmesh.collapse.QuadricSimplifier}. */
    QUADRIC,

    /** Chen and Nishita 2002: {@link org.jsmesh.collapse.PaperSimplifier}. */
    PAPER
}
