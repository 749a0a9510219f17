package org.jsmesh.samples;

import java.util.ArrayList;
import java.util.List;

/**
 * The outline of a gear with involute teeth, pressure angle 20°, module 1: its pitch circle has a diameter of one per
 * tooth.
 */
record GearProfile(int teeth, double root, double tip, double backlash) {
    private static final double PRESSURE = StrictMath.PI / 9;
    private static final int FLANK_POINTS = 3;

    /** The usual proportions: teeth stand one module beyond the pitch circle and reach 1.25 below it. */
    static GearProfile external(int teeth) {
        return new GearProfile(teeth, 0.5 * teeth - 1.25, 0.5 * teeth + 1, 0.06);
    }

    /** The hole of a ring gear: the teeth of this outline are the spaces of the ring. */
    static GearProfile internal(int teeth) {
        return new GearProfile(teeth, 0.5 * teeth - 1, 0.5 * teeth + 1.25, -0.06);
    }

    double pitch() {
        return 0.5 * teeth;
    }

    /** One tooth is centred on angle 0. */
    List<Solid.Polar> outline() {
        return outline(0, 9e9);
    }

    /** The outline, with all points brought between these two distances from the axis. */
    List<Solid.Polar> outline(double least, double most) {
        List<Solid.Polar> loop = new ArrayList<>();
        double base = pitch() * StrictMath.cos(PRESSURE);
        double from = StrictMath.max(base, root + 0.15);
        for (int tooth = 0; tooth < teeth; tooth++) {
            double centre = 2 * StrictMath.PI * tooth / teeth;
            double foot = halfAngle(from) + 0.12 / root;
            add(loop, root, centre - foot, least, most);
            for (int i = 0; i < FLANK_POINTS; i++) {
                double radius = Blend.mix(from, tip, i / (FLANK_POINTS - 1.0));
                add(loop, radius, centre - halfAngle(radius), least, most);
            }
            for (int i = FLANK_POINTS - 1; i >= 0; i--) {
                double radius = Blend.mix(from, tip, i / (FLANK_POINTS - 1.0));
                add(loop, radius, centre + halfAngle(radius), least, most);
            }
            add(loop, root, centre + foot, least, most);
        }
        return loop;
    }

    private static void add(List<Solid.Polar> loop, double radius, double angle, double least, double most) {
        loop.add(new Solid.Polar(StrictMath.max(least, StrictMath.min(most, radius)), angle));
    }

    /** Half the angle that a tooth covers at this distance from the axis. */
    private double halfAngle(double radius) {
        double base = pitch() * StrictMath.cos(PRESSURE);
        double alpha = StrictMath.acos(StrictMath.min(1, base / radius));
        double half = (0.5 * StrictMath.PI - backlash) / teeth;
        return half + involute(PRESSURE) - involute(alpha);
    }

    private static double involute(double alpha) {
        return StrictMath.tan(alpha) - alpha;
    }
}
