package org.jsmesh.display;

/**
 * The angle between neighbouring faces above which an edge is drawn sharp when the model has no normals of its own. A
 * coarse mesh of a round shape has large angles between its faces, the original small ones, so the angle falls from 75°
 * at the base to 42° at the original with the logarithm of the faces.
 */
public final class CreaseAngle {
    private static final double AT_BASE = 75;
    private static final double AT_ORIGINAL = 42;
    private static final int HALVINGS = 40;
    private static final int SERIES_POWER = 20;

    private CreaseAngle() {}

    /**
     * Cosine of the angle for a level of detail, the same on every platform.
     *
     * @param faces of the mesh shown
     * @param baseFaces of the base mesh, at least 1
     * @param allFaces of the original; {@link Integer#MAX_VALUE} while it is not known
     * @return the cosine, from about .26 for the base to about .74 for the original
     */
    public static double cosine(int faces, int baseFaces, int allFaces) {
        double refined = faces >= allFaces || allFaces <= baseFaces ? 1 : refined(faces, baseFaces, allFaces);
        double degrees = AT_ORIGINAL - AT_BASE;
        degrees = degrees * refined + AT_BASE;
        return cos(degrees * Math.PI / 180);
    }

    /**
     * How far between two numbers a third lies on a logarithmic scale, 0 to 1: halves the interval at its geometric
     * mean, as the logarithms of the platforms differ in their last bits.
     */
    private static double refined(double faces, double baseFaces, double allFaces) {
        double low = baseFaces;
        double high = allFaces;
        double share = 0;
        double half = 1;
        for (int i = 0; i < HALVINGS; i++) {
            double mean = Math.sqrt(low * high);
            half /= 2;
            if (faces < mean) {
                high = mean;
            } else {
                low = mean;
                share += half;
            }
        }
        return share;
    }

    /** The cosine of an angle below 90° by its Taylor series. */
    private static double cos(double radians) {
        double square = radians * radians;
        double sum = 1;
        for (int n = SERIES_POWER; n > 0; n -= 2) sum = 1 - square * sum / (n * (n - 1));
        return sum;
    }
}
