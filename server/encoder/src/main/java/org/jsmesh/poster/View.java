package org.jsmesh.poster;

import org.jsmesh.mesh.UpAxis;
import org.jsmesh.studio.ContactShadow;

/**
 * The camera at which the page shows a model first: from the front, somewhat from the right and from above, with all of
 * the bounding box in the picture. The model lies in a space where its bounding sphere is the unit sphere around the
 * origin and y points up.
 */
final class View {
    private static final double[] START_DIRECTION = {.55, .32, 1};
    private static final double FIELD_OF_VIEW = 35; // degrees, upright
    /** Share of the picture that the bounding box fills. */
    private static final double FILLED = .96;

    /** Nothing nearer to the eye is drawn. */
    private static final double NEAR = 1. / 200;

    /** Axes of the eye in the model's space: to the right, up, and towards the viewer. */
    final double[] right;

    final double[] up;
    final double[] back;
    final double distance;
    private final double scaleAcross;
    private final double scaleUp;
    private final double[] centre = new double[3];
    private final double[] box;
    private final double radius;
    private final boolean isTurned;

    /**
     * @param bounds smallest x, y, z, then largest x, y, z
     * @param axis of the model that points up
     * @param aspect width of the picture over its height
     */
    View(float[] bounds, UpAxis axis, double aspect) {
        double[] half = new double[3];
        for (int k = 0; k < 3; k++) {
            half[k] = ((double) bounds[k + 3] - bounds[k]) / 2;
            centre[k] = bounds[k] + half[k];
        }
        double length = length(half);
        radius = length > 0 ? length : 1;
        isTurned = axis == UpAxis.Z;
        box = new double[] {half[0] / radius, half[isTurned ? 2 : 1] / radius, half[isTurned ? 1 : 2] / radius};
        back = unit(START_DIRECTION);
        right = unit(new double[] {back[2], 0, -back[0]});
        up = cross(back, right);
        double slope = StrictMath.tan(StrictMath.toRadians(FIELD_OF_VIEW / 2));
        double far = 0;
        for (int corner = 0; corner < 8; corner++) {
            double[] p = new double[3];
            for (int k = 0; k < 3; k++) p[k] = ((corner >> k & 1) == 0 ? -box[k] : box[k]);
            double wide = Math.max(Math.abs(dot(p, right)) / aspect, Math.abs(dot(p, up)));
            far = Math.max(far, dot(p, back) + wide / (FILLED * slope));
        }
        distance = far;
        scaleUp = 1 / slope;
        scaleAcross = scaleUp / aspect;
    }

    /** Positions in the space of the picture, x, y, z per point. */
    float[] placed(float[] positions) {
        float[] placed = new float[positions.length];
        for (int i = 0; i < positions.length; i += 3) {
            for (int k = 0; k < 3; k++) placed[i + k] = (float) ((positions[i + k] - centre[k]) / radius);
            turn(placed, i);
        }
        return placed;
    }

    /** Directions in that space, made unit vectors; zeros stay. */
    float[] turned(float[] directions, int stride) {
        float[] turned = directions.clone();
        for (int i = 0; i < turned.length; i += stride) {
            turn(turned, i);
            double length = length(turned[i], turned[i + 1], turned[i + 2]);
            if (length > 0) for (int k = 0; k < 3; k++) turned[i + k] /= (float) length;
        }
        return turned;
    }

    private void turn(float[] points, int at) {
        if (!isTurned) return;
        float z = -points[at + 1];
        points[at + 1] = points[at + 2];
        points[at + 2] = z;
    }

    /** The shadow of a model whose positions are in the space of the picture. */
    ContactShadow shadow(float[] placed, int[] indices) {
        return ContactShadow.of(placed, indices, box[0], box[1], box[2]);
    }

    /**
     * Share of the light that a shadow keeps from a place of the picture.
     *
     * @param across from −1 at the left edge of the picture to 1 at the right one
     * @param upwards likewise, from the lower edge to the upper one
     */
    double shadowed(ContactShadow shadow, double across, double upwards) {
        double[] ray = new double[3];
        for (int k = 0; k < 3; k++) ray[k] = right[k] * across / scaleAcross + up[k] * upwards / scaleUp - back[k];
        double length = (shadow.height() - distance * back[1]) / ray[1];
        if (!(length > 0)) return 0;
        return shadow.at(distance * back[0] + length * ray[0], distance * back[2] + length * ray[2]);
    }

    /** How far in front of the eye a point is; 0 when it is too near to be drawn. */
    double depth(float[] points, int at) {
        double depth = distance - dot(points, at, back);
        return depth > NEAR ? depth : 0;
    }

    /** From −1 at the left edge of the picture to 1 at the right one. */
    double across(float[] points, int at, double depth) {
        return dot(points, at, right) * scaleAcross / depth;
    }

    /** From −1 at the lower edge of the picture to 1 at the upper one. */
    double upwards(float[] points, int at, double depth) {
        return dot(points, at, up) * scaleUp / depth;
    }

    private static double dot(float[] points, int at, double[] b) {
        return points[at] * b[0] + points[at + 1] * b[1] + points[at + 2] * b[2];
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    static double[] unit(double[] v) {
        double length = length(v);
        return length == 0 ? v : new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    private static double length(double[] v) {
        return length(v[0], v[1], v[2]);
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
