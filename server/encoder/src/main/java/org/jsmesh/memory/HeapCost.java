package org.jsmesh.memory;

import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.Simplifier;

/**
 * Bytes of heap by what a model has, measured by encoding models with ever less heap and Java's serial collector; see
 * the table in docs/operation.md. G1 needs a quarter more.
 */
final class HeapCost {
    /** The program and the tables of its coders. */
    private static final double PROGRAM = 18e6;

    private static final double FACE = 260;

    /** A face that shares no vertex with another: it has three vertices and three borders of its own. */
    private static final double SEPARATE_FACE = 1250;

    private static final double FACE_WITH_MATERIAL = 60;
    private static final double FACE_IN_ORDER = 30;

    /** A value of an attribute at a vertex. */
    private static final double VALUE = 40;

    /** A face while its file is read. */
    private static final double FACE_READ = 100;

    // Encoding with less has never been seen.
    private static final double LEAST_FACE = 140;
    private static final double LEAST_FACE_OF_PAPER = 90;

    private HeapCost() {}

    static MemoryEstimate of(ModelCount count, EncoderSettings settings) {
        double face = count.isSoup() ? SEPARATE_FACE : FACE;
        if (count.hasMaterials()) face += FACE_WITH_MATERIAL;
        if (settings.keepOrder()) face += FACE_IN_ORDER;
        double values = VALUE * count.channels() * Math.max(count.vertices(), count.faces() / 2);
        double encoding = face * count.faces() + values;
        double reading = FACE_READ * count.faces() + count.fileBytes() + count.unpackedBytes();
        double least =
                (settings.simplifier() == Simplifier.PAPER ? LEAST_FACE_OF_PAPER : LEAST_FACE) * count.leastFaces();
        long bytes = (long) (PROGRAM + Math.max(encoding, reading));
        return new MemoryEstimate((long) count.faces(), count.channels(), bytes, Math.min(bytes, (long) least));
    }

    /** Faces that surely fit: with a normal, a texture coordinate and a material. */
    static long faces(long heapBytes) {
        double face = FACE + FACE_WITH_MATERIAL + 5 * VALUE / 2;
        return Math.max(1, (long) ((heapBytes - PROGRAM) / face));
    }
}
