package org.jsmesh.test.picture;

/**
 * A perspective camera in model space.
 *
 * @param eye x, y, z of the eye
 * @param target x, y, z of the point in the middle of the picture
 * @param up a direction that is up in the picture, not parallel to the line of sight
 * @param fieldOfView vertical, in degrees
 */
public record View(double[] eye, double[] target, double[] up, double fieldOfView) {
    /**
     * The view that shows the whole of a model as the desktop viewer does at its start: from the smallest distance at
     * which the corners of the box lie in the middle of the picture.
     *
     * @param bounds smallest x, y, z, then largest x, y, z
     * @param yaw degrees around +y, 0 looks along −z
     * @param pitch degrees above the horizon
     * @param fieldOfView vertical, in degrees
     * @param filled share of the picture's width and height that the box may fill
     * @param aspect width / height of the picture
     */
    public static View framing(
            float[] bounds, double yaw, double pitch, double fieldOfView, double filled, double aspect) {
        double[] centre = new double[3];
        for (int k = 0; k < 3; k++) centre[k] = ((double) bounds[k] + bounds[k + 3]) / 2;
        double y = Math.toRadians(yaw);
        double p = Math.toRadians(pitch);
        double[] back = {Math.sin(y) * Math.cos(p), Math.sin(p), Math.cos(y) * Math.cos(p)};
        double[][] axes = new View(back, new double[3], new double[] {0, 1, 0}, fieldOfView).axes();
        double slope = filled * Math.tan(Math.toRadians(fieldOfView) / 2);
        double distance = 0;
        for (int i = 0; i < 8; i++) {
            double[] corner = {bounds[(i & 1) * 3], bounds[1 + (i >> 1 & 1) * 3], bounds[2 + (i >> 2) * 3]};
            double[] d = Vectors.minus(corner, centre);
            double across = Math.abs(Vectors.dot(axes[0], d)) / aspect;
            double along = Math.abs(Vectors.dot(axes[1], d));
            distance = Math.max(distance, Vectors.dot(axes[2], d) + Math.max(across, along) / slope);
        }
        double[] eye = new double[3];
        for (int k = 0; k < 3; k++) eye[k] = centre[k] + distance * back[k];
        return new View(eye, centre, new double[] {0, 1, 0}, fieldOfView);
    }

    /** Axes of eye space in model space: right, up, towards the viewer. */
    double[][] axes() {
        double[] back = Vectors.unit(Vectors.minus(eye, target));
        double[] right = Vectors.unit(Vectors.cross(up, back));
        return new double[][] {right, Vectors.cross(back, right), back};
    }
}
