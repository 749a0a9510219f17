package org.jsmesh.display;

/**
 * The angle between neighbouring faces from which on an edge is drawn sharp when the model has no normals of its own. A
 * coarse mesh of a round shape has large angles between its faces, the original small ones, so the angle falls from 75°
 * at the base to 42° at the original with the logarithm of the faces.
 */
public final class CreaseAngle {
    private static final double AT_BASE = 75;
    private static final double AT_ORIGINAL = 42;

    private CreaseAngle() {}

    /** Cosine of the angle for a mesh of {@code faces} faces between the base and the original. */
    public static double cosine(int faces, int baseFaces, int allFaces) {
        double refined = allFaces <= baseFaces || faces >= allFaces
                ? 1
                : Math.log((double) Math.max(faces, baseFaces) / baseFaces) / Math.log((double) allFaces / baseFaces);
        return Math.cos(Math.toRadians(AT_BASE + (AT_ORIGINAL - AT_BASE) * refined));
    }
}
