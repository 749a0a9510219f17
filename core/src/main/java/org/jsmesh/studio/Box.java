package org.jsmesh.studio;

/** A box that is turned around the y axis, as rays from the origin meet it. */
final class Box {
    private final double[] centre; // along the axes of the box
    private final double[] half;
    private final double sine;
    private final double cosine;

    /**
     * @param centre x, y, z
     * @param half half its width, height and depth
     * @param sine of the angle that it is turned by
     * @param cosine of that angle
     */
    Box(double[] centre, double[] half, double sine, double cosine) {
        this.sine = sine;
        this.cosine = cosine;
        this.half = half;
        this.centre = turned(centre);
    }

    /** How far the ray goes until it enters the box; infinite where it misses it or starts inside. */
    double enter(double[] direction) {
        double enters = entered(direction);
        return enters > 0 && enters < leave(direction) ? enters : Double.POSITIVE_INFINITY;
    }

    /** How far the ray goes until it leaves the box. */
    double leave(double[] direction) {
        double x = across(along(direction, 0), 0);
        double y = across(direction[1], 1);
        double z = across(along(direction, 2), 2);
        return Math.min(x, Math.min(y, z));
    }

    /** The unit normal, turned to the origin, of the side that the ray meets after a distance. */
    double[] normal(double[] direction, double distance) {
        double[] d = turned(direction);
        int side = 0;
        double closest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            double off = Math.abs(Math.abs(distance * d[k] - centre[k]) - half[k]);
            if (off >= closest) continue;
            closest = off;
            side = k;
        }
        double sign = -Math.signum(d[side]);
        return switch (side) {
            case 0 -> new double[] {sign * cosine, 0, -sign * sine};
            case 1 -> new double[] {0, sign, 0};
            default -> new double[] {sign * sine, 0, sign * cosine};
        };
    }

    /** Where the ray is within all pairs of sides (Kay and Kajiya 1986); behind the place to leave where it misses. */
    private double entered(double[] direction) {
        double x = into(along(direction, 0), 0);
        double y = into(direction[1], 1);
        double z = into(along(direction, 2), 2);
        return Math.max(x, Math.max(y, z));
    }

    private double into(double step, int axis) {
        return Math.min((centre[axis] - half[axis]) / step, (centre[axis] + half[axis]) / step);
    }

    private double across(double step, int axis) {
        return Math.max((centre[axis] - half[axis]) / step, (centre[axis] + half[axis]) / step);
    }

    /** A direction along the box' first (0) or third axis (2). */
    private double along(double[] v, int axis) {
        return axis == 0 ? cosine * v[0] - sine * v[2] : sine * v[0] + cosine * v[2];
    }

    /** A vector along the axes of the box. */
    private double[] turned(double[] v) {
        return new double[] {along(v, 0), v[1], along(v, 2)};
    }
}
