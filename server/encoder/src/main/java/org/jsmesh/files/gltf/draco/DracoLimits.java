package org.jsmesh.files.gltf.draco;

import org.jsmesh.files.gltf.packed.PackedException;

/**
 * What a Draco mesh may grow to: what the caller allows, and a multiple of its bytes. Entropy coding stores many equal
 * values in no bits at all, so the bytes alone set no limit. A flat regular grid comes to about a third of the
 * multiple, other meshes stay far below.
 */
final class DracoLimits {
    private static final long MOST_PER_BYTE = 512;
    private static final long ALWAYS_ALLOWED = 1 << 20;
    private static final int MOST_ATTRIBUTES = 256;

    private final int mostPoints;
    private final long mostFaces;
    private long valuesLeft;
    private int attributesLeft = MOST_ATTRIBUTES;

    DracoLimits(int bytes, int mostPoints, int mostFaces) {
        long most = Math.max(ALWAYS_ALLOWED, MOST_PER_BYTE * bytes);
        this.mostPoints = mostPoints;
        this.mostFaces = Math.min(mostFaces, most);
        valuesLeft = most;
    }

    void requireFaces(int count) throws PackedException {
        if (count > mostFaces) throw tooMany(count, "faces");
    }

    void requirePoints(int count) throws PackedException {
        if (count > mostPoints) throw tooMany(count, "points");
    }

    void takeAttributes(int count) throws PackedException {
        if (count > attributesLeft) throw tooMany(count, "attributes");
        attributesLeft -= count;
    }

    /** Counts the numbers of an attribute. */
    void takeValues(int entries, int components) throws PackedException {
        long count = (long) entries * components;
        if (count > valuesLeft) throw tooMany(count, "numbers");
        valuesLeft -= count;
    }

    private static PackedException tooMany(long count, String what) {
        return new PackedException("the Draco data has " + count + " " + what + ", which is too many");
    }
}
