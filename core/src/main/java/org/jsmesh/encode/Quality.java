package org.jsmesh.encode;

import org.jsmesh.collapse.Effort;
import org.jsmesh.encode.write.CoarseFit;

/** How much time may go into the shape of the levels of detail. The original comes back bit for bit with any. */
public enum Quality {
    /** Half the time, coarse levels up to a few percent further from the original. */
    FAST(Effort.LITTLE, CoarseFit.Effort.LITTLE),

    /** The best for its time. */
    DEFAULT(Effort.SOME, CoarseFit.Effort.SOME),

    /** Several times slower: costs are distances measured at points of the original. */
    BEST(Effort.MUCH, CoarseFit.Effort.MUCH);

    final Effort collapsing;
    final CoarseFit.Effort fitting;

    Quality(Effort collapsing, CoarseFit.Effort fitting) {
        this.collapsing = collapsing;
        this.fitting = fitting;
    }
}
