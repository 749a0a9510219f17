package org.jsmesh.collapse;

/** How much time may go into the shape of the levels of detail. */
public enum Quality {
    /** Half the time, coarse levels up to a few percent further from the original. */
    FAST,

    /** The best for its time. */
    DEFAULT,

    /** Several times slower: costs are distances measured at points of the original. */
    BEST
}
