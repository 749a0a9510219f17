package org.jsmesh.desktop.draw;

import org.jsmesh.mesh.UpAxis;

/**
 * The similarity that takes model coordinates to unit space, where the bounding sphere of the whole original is the
 * unit sphere around the origin: {@code u = (p − centre) / radius}. It comes from the bounds of the original, so that
 * no refinement moves or rescales the picture. It is computed in double, so that models far from their origin keep
 * their detail in the float32 of the graphics card. Where z points up, (x, y, z) then becomes (x, z, −y), so that y
 * points up in unit space.
 *
 * @param x centre of the bounding box
 * @param y centre of the bounding box
 * @param z centre of the bounding box
 * @param radius half the diagonal of the bounding box, 1 when the box is a point
 * @param isTurned whether z points up
 * @param halfX half the width of the bounding box in unit space
 * @param halfY half its height
 * @param halfZ half its depth
 */
public record Framing(
        double x, double y, double z, double radius, boolean isTurned, double halfX, double halfY, double halfZ) {
    /**
     * @param bounds smallest x, y, z, then largest x, y, z
     * @param up the axis that points up
     */
    public static Framing of(float[] bounds, UpAxis up) {
        double hx = ((double) bounds[3] - bounds[0]) / 2;
        double hy = ((double) bounds[4] - bounds[1]) / 2;
        double hz = ((double) bounds[5] - bounds[2]) / 2;
        double diagonal = Math.sqrt(hx * hx + hy * hy + hz * hz);
        double radius = diagonal > 0 ? diagonal : 1;
        boolean turned = up == UpAxis.Z;
        double height = turned ? hz : hy;
        double depth = turned ? hy : hz;
        return new Framing(
                bounds[0] + hx,
                bounds[1] + hy,
                bounds[2] + hz,
                radius,
                turned,
                hx / radius,
                height / radius,
                depth / radius);
    }

    /** Positions in unit space, three per vertex. */
    public float[] toUnit(float[] positions) {
        float[] unit = new float[positions.length];
        for (int i = 0; i < positions.length; i += 3) {
            unit[i] = (float) ((positions[i] - x) / radius);
            unit[i + 1] = (float) ((positions[i + 1] - y) / radius);
            unit[i + 2] = (float) ((positions[i + 2] - z) / radius);
        }
        return upright(unit, 3);
    }

    /**
     * Directions of the model in unit space.
     *
     * @param stride numbers of each direction, of which the first three are x, y, z
     */
    public float[] toUnitDirections(float[] directions, int stride) {
        return isTurned ? upright(directions.clone(), stride) : directions;
    }

    /**
     * Positions as raw bits, in their place.
     *
     * @param stride numbers of each position, of which the first three are x, y, z
     */
    void toUnit(int[] bits, int from, int to, int stride) {
        for (int i = from; i < to; i += stride) {
            bits[i] = Float.floatToRawIntBits((float) ((Float.intBitsToFloat(bits[i]) - x) / radius));
            bits[i + 1] = Float.floatToRawIntBits((float) ((Float.intBitsToFloat(bits[i + 1]) - y) / radius));
            bits[i + 2] = Float.floatToRawIntBits((float) ((Float.intBitsToFloat(bits[i + 2]) - z) / radius));
        }
        turn(bits, from, to, stride);
    }

    /** Directions as raw bits, in their place. */
    void turn(int[] bits, int from, int to, int stride) {
        if (!isTurned) return;
        for (int i = from; i < to; i += stride) {
            int back = bits[i + 1] ^ Integer.MIN_VALUE;
            bits[i + 1] = bits[i + 2];
            bits[i + 2] = back;
        }
    }

    private float[] upright(float[] points, int stride) {
        if (!isTurned) return points;
        for (int i = 0; i < points.length; i += stride) {
            float back = -points[i + 1];
            points[i + 1] = points[i + 2];
            points[i + 2] = back;
        }
        return points;
    }
}
