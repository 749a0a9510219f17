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

    /** Places by face in a surface; where there are more, faces share fewer, and have borders. */
    private static final double USUAL_PLACES = .55;

    /** Beyond this they cost no more: faces that share an edge in pairs take most, two places each. */
    private static final double MOST_PLACES = 1.55;

    private static final double FURTHER_PLACE = 380;

    private static final double FACE_WITH_MATERIAL = 60;
    private static final double FACE_IN_ORDER = 30;

    /** A value of an attribute at a wedge. */
    private static final double VALUE = 40;

    /** A face while its file is read. */
    private static final double FACE_READ = 100;

    // Encoding with less has never been seen.
    private static final double LEAST_FACE = 140;
    private static final double LEAST_FACE_OF_PAPER = 90;

    private HeapCost() {}

    static MemoryEstimate of(ModelCount count, EncoderSettings settings) {
        double face = FACE;
        if (count.isByPlace() && count.faces() > 0)
            face += FURTHER_PLACE * Math.max(0, Math.min(MOST_PLACES, count.vertices() / count.faces()) - USUAL_PLACES);
        if (count.hasMaterials()) face += FACE_WITH_MATERIAL;
        if (settings.keepOrder()) face += FACE_IN_ORDER;
        double wedges = Math.max(count.wedges(), Math.max(count.vertices(), count.faces() / 2));
        double values = VALUE * count.channels() * wedges;
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
