package org.jsmesh.desktop.draw;

/**
 * An orbiting perspective camera in the unit space of {@link Framing}. Immutable; every movement gives another camera.
 *
 * <p>The formula, so that other renderers can draw the same picture: the eye is at {@code target + distance · (sin yaw
 * · cos pitch, sin pitch, cos yaw · cos pitch)}, looks at the target, and +y is up; the vertical field of view is
 * {@link #FIELD_OF_VIEW}. {@link #framing} looks at the origin from the smallest distance at which the eight corners of
 * the bounding box lie in the middle 98% of the window: the largest {@code z + max(|x| · height / width, |y|) / (.98 ·
 * tan(FIELD_OF_VIEW / 2))} of a corner, where x, y, z are its coordinates along right, up and towards the viewer.
 * Angles are in radians.
 *
 * @param yaw angle around the y axis, 0 looks along −z
 * @param pitch angle above the horizon
 * @param distance from the eye to the target
 * @param targetX point looked at
 * @param targetY point looked at
 * @param targetZ point looked at
 */
public record Camera(double yaw, double pitch, double distance, double targetX, double targetY, double targetZ) {
    /** Vertical field of view in radians: 35 degrees. */
    public static final double FIELD_OF_VIEW = Math.toRadians(35);

    private static final double FILLED = .98;
    private static final double START_YAW = Math.toRadians(30);
    private static final double START_PITCH = Math.toRadians(20);
    private static final double STEEPEST = Math.toRadians(89);
    private static final double NEAREST = .02;
    private static final double FARTHEST = 40;

    /**
     * Shows the whole model in a window.
     *
     * @param width of the window, in any unit
     * @param height of the window, in the same
     * @return a camera in front of the model, to the right and a little above
     */
    public static Camera framing(Framing box, int width, int height) {
        double[] v = new Camera(START_YAW, START_PITCH, 0, 0, 0, 0).view();
        double slope = FILLED * Math.tan(FIELD_OF_VIEW / 2);
        double distance = NEAREST;
        for (int corner = 0; corner < 8; corner++) {
            double px = (corner & 1) == 0 ? -box.halfX() : box.halfX();
            double py = (corner & 2) == 0 ? -box.halfY() : box.halfY();
            double pz = (corner & 4) == 0 ? -box.halfZ() : box.halfZ();
            double x = v[0] * px + v[4] * py + v[8] * pz;
            double y = v[1] * px + v[5] * py + v[9] * pz;
            double z = v[2] * px + v[6] * py + v[10] * pz;
            distance = Math.max(distance, z + Math.max(Math.abs(x) * height / width, Math.abs(y)) / slope);
        }
        return new Camera(START_YAW, START_PITCH, distance, 0, 0, 0);
    }

    /**
     * Turns around the target; the pitch stops short of the poles.
     *
     * @return the turned camera
     */
    public Camera orbit(double yawBy, double pitchBy) {
        double steep = Math.max(-STEEPEST, Math.min(STEEPEST, pitch + pitchBy));
        return new Camera((yaw + yawBy) % (2 * Math.PI), steep, distance, targetX, targetY, targetZ);
    }

    /**
     * Multiplies the distance, within limits.
     *
     * @return the nearer or farther camera
     */
    public Camera zoom(double factor) {
        double d = Math.max(NEAREST, Math.min(FARTHEST, distance * factor));
        return new Camera(yaw, pitch, d, targetX, targetY, targetZ);
    }

    /**
     * Multiplies the distance, within limits.
     *
     * @param about x, y, z of a point that stays where it is in the picture
     * @return the nearer or farther camera
     */
    public Camera zoom(double factor, double[] about) {
        Camera nearer = zoom(factor);
        double share = nearer.distance / distance;
        return new Camera(
                yaw,
                pitch,
                nearer.distance,
                about[0] + share * (targetX - about[0]),
                about[1] + share * (targetY - about[1]),
                about[2] + share * (targetZ - about[2]));
    }

    /**
     * Tells how far a point lies before the eye.
     *
     * @param point x, y, z
     * @return the distance in the direction in which the eye looks; negative behind it
     */
    public double depth(double[] point) {
        double[] v = view();
        return -(v[2] * point[0] + v[6] * point[1] + v[10] * point[2] + v[14]);
    }

    /**
     * Finds the point that is seen at a place.
     *
     * @param across from −1 at the left edge to 1 at the right one
     * @param along from −1 at the lower edge to 1 at the upper one
     * @param aspect width of the window through its height
     * @param depth before the eye
     * @return x, y, z
     */
    public double[] point(double across, double along, double aspect, double depth) {
        double slope = depth * Math.tan(FIELD_OF_VIEW / 2);
        double[] v = view();
        double[] e = eye();
        double[] point = new double[3];
        for (int k = 0; k < 3; k++)
            point[k] = e[k] + across * aspect * slope * v[4 * k] + along * slope * v[4 * k + 1] - depth * v[4 * k + 2];
        return point;
    }

    /**
     * Moves eye and target by fractions of the window's height. A point at the target's depth then follows the pointer.
     *
     * @return the moved camera
     */
    public Camera pan(double rightBy, double upBy) {
        return pan(rightBy, upBy, distance);
    }

    /**
     * Moves eye and target by fractions of the window's height.
     *
     * @param depth before the eye of the points that then follow the pointer
     * @return the moved camera
     */
    public Camera pan(double rightBy, double upBy, double depth) {
        double scale = 2 * depth * Math.tan(FIELD_OF_VIEW / 2);
        double[] v = view();
        double right = rightBy * scale;
        double up = upBy * scale;
        return new Camera(
                yaw,
                pitch,
                distance,
                targetX - v[0] * right - v[1] * up,
                targetY - v[4] * right - v[5] * up,
                targetZ - v[8] * right - v[9] * up);
    }

    /**
     * Tells how large the model is: what is off by a part of its diagonal is off by that part of this.
     *
     * @param height of the picture in pixels
     * @return pixels that the diagonal of the model's bounding box is long at the place of the unit sphere that is
     *     nearest to the eye; the eye is taken to be no nearer than {@value #NEAREST}
     */
    public double diagonalPixels(int height) {
        double[] e = eye();
        double away = Math.sqrt(dot(e, e)) - 1;
        return height / (Math.tan(FIELD_OF_VIEW / 2) * Math.max(away, NEAREST));
    }

    /** {@return x, y, z of the eye} */
    public double[] eye() {
        return new double[] {
            targetX + distance * Math.sin(yaw) * Math.cos(pitch),
            targetY + distance * Math.sin(pitch),
            targetZ + distance * Math.cos(yaw) * Math.cos(pitch)
        };
    }

    /** {@return the matrix from unit space to eye space (x right, y up, looking along −z), column by column} */
    public double[] view() {
        double[] e = eye();
        double sinYaw = Math.sin(yaw);
        double cosYaw = Math.cos(yaw);
        double[] right = {cosYaw, 0, -sinYaw};
        double[] back = {sinYaw * Math.cos(pitch), Math.sin(pitch), cosYaw * Math.cos(pitch)};
        double[] up = {-sinYaw * Math.sin(pitch), Math.cos(pitch), -cosYaw * Math.sin(pitch)};
        return new double[] {
            right[0],
            up[0],
            back[0],
            0,
            right[1],
            up[1],
            back[1],
            0,
            right[2],
            up[2],
            back[2],
            0,
            -dot(right, e),
            -dot(up, e),
            -dot(back, e),
            1
        };
    }

    /**
     * Projects into a window in perspective; near and far planes enclose the unit sphere tightly.
     *
     * @param width of the window, in any unit
     * @param height of the window, in the same
     * @return a matrix, column by column
     */
    public double[] projection(int width, int height) {
        double offset = Math.sqrt(targetX * targetX + targetY * targetY + targetZ * targetZ);
        double reach = 1.02 + offset;
        double near = Math.max(distance - reach, distance / 500);
        double far = distance + reach;
        double f = 1 / Math.tan(FIELD_OF_VIEW / 2);
        double aspect = (double) width / height;
        return new double[] {
            f / aspect,
            0,
            0,
            0,
            0,
            f,
            0,
            0,
            0,
            0,
            (far + near) / (near - far),
            -1,
            0,
            0,
            2 * far * near / (near - far),
            0
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
