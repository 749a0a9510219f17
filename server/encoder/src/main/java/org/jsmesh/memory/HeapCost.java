package org.jsmesh.memory;

import org.jsmesh.encode.EncoderSettings;

/** Bytes of heap by what a model has, measured by encoding models with ever less heap. */
final class HeapCost {
    private static final double PROGRAM = 24e6;
    private static final double FACE = 270;
    private static final double LEAST_FACE = 180;

    private HeapCost() {}

    static MemoryEstimate of(ModelCount count, EncoderSettings settings) {
        double values = 8.0 * count.channels() * Math.max(count.vertices(), count.faces() / 2);
        double bytes = PROGRAM + FACE * count.faces() + values + count.fileBytes() + count.unpackedBytes();
        double least = LEAST_FACE * count.leastFaces();
        return new MemoryEstimate((long) count.faces(), count.channels(), (long) Math.max(bytes, least), (long) least);
    }
}
