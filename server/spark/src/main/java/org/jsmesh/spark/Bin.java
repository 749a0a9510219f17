package org.jsmesh.spark;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/**
 * Models that one task encodes, one after another.
 *
 * @param number of the bin in its run
 * @param packed the models, see {@link Packed}
 */
record Bin(int number, byte[] packed) implements Serializable {
    private static final long serialVersionUID = 1;

    List<PlannedModel> models() {
        return Packed.planned(packed);
    }

    /**
     * Cuts models into bins of about the same time. Those that come largest first give bins of models alike in memory,
     * and the short ones at the end, so that no executor is left with a long one.
     *
     * @param models largest first
     * @param seconds that a bin should take on one core; one model may take longer
     * @return the bins in the same order
     */
    static Iterator<byte[]> cut(Iterator<PlannedModel> models, double seconds) {
        return new Iterator<>() {
            private PlannedModel next = models.hasNext() ? models.next() : null;

            @Override
            public boolean hasNext() {
                return next != null;
            }

            @Override
            public byte[] next() {
                if (next == null) throw new java.util.NoSuchElementException();
                List<PlannedModel> bin = new ArrayList<>();
                double sum = 0;
                while (next != null && bin.size() < Packed.MOST && (bin.isEmpty() || sum + next.seconds() <= seconds)) {
                    bin.add(next);
                    sum += next.seconds();
                    next = models.hasNext() ? models.next() : null;
                }
                return Packed.planned(bin);
            }
        };
    }
}
