package org.jsmesh.encode;

import org.jsmesh.collapse.Effort;
import org.jsmesh.encode.write.CoarseFit;

/** How much time may go into the shape of the levels of detail. The original comes back bit for bit with any. */
public enum Quality {
    /**
     * Half the time for models of up to 300,000 faces, three quarters for millions. Coarse levels are further from the
     * original, because no vertex is moved to where it would fit best, and predictors decode faster and give somewhat
     * larger archives.
     */
    FAST(Effort.LITTLE, CoarseFit.Effort.NONE, false),

    /** The best for its time. */
    DEFAULT(Effort.SOME, CoarseFit.Effort.SOME, true),

    /** Several times slower: costs are distances measured at points of the original. */
    BEST(Effort.MUCH, CoarseFit.Effort.MUCH, true);

    final Effort collapsing;
    final CoarseFit.Effort fitting;
    final boolean dense; // predictors

    Quality(Effort collapsing, CoarseFit.Effort fitting, boolean dense) {
        this.collapsing = collapsing;
        this.fitting = fitting;
        this.dense = dense;
    }
}
