package org.jsmesh.encode.write;

import org.jsmesh.codec.lod.LodSurface;

/**
 * Measures how far levels of detail are from the original: distances in % of the diagonal of the original's bounding
 * box. The levels come coarsest first.
 */
public interface ErrorMeter {
    /**
     * What is found out about a level; what it says before the meter has {@linkplain ErrorMeter#finish finished} is a
     * first guess.
     */
    interface Sounding {
        /** Mean of the distances from either surface to the other. */
        double mean();

        /** The largest distance found; 0 when none was looked for. */
        double largest();
    }

    /**
     * Measures a level as it is shown.
     *
     * @param thorough how well: the others count in relation to the thorough ones before and after
     */
    Sounding sound(LodSurface shown, boolean thorough);

    /**
     * Measures the level sounded last again after its vertices have moved a little.
     *
     * @param wholly with as many points as it was sounded with
     */
    Sounding soundMoved(LodSurface.Places places, boolean wholly);

    /** Mean distance from the original to a level with exact positions, about. */
    double mean(LodSurface exact);

    /** Completes all soundings. */
    void finish();
}
