package org.jsmesh.samples;

import java.util.ArrayList;
import java.util.List;

/**
 * The smooth organic sample: an octopus, resting on the ground plane y = 0 and looking along +z, with a colour per
 * vertex.
 */
final class Octopus {
    private static final double STEP = 0.0261;
    private static final double[] EYE = {0.225, 0.87, 0.25};
    private static final double EYE_RADIUS = 0.14;

    private final List<Arm> arms = new ArrayList<>();

    private Octopus() {
        double turn = StrictMath.PI / 180;
        double[][] poses = {
            // azimuth, length, sway, phase, curl start, curl up, curl sideways
            {66, 2.55, 0.55, 2.6, 0.56, 0.4, 8.6},
            {114, 2.75, 0.5, 0.2, 0.60, 8.8, 0.9},
            {159, 2.60, 0.6, 3.3, 0.55, 0.5, -8.4},
            {204, 2.70, 0.45, 0.4, 0.62, 7.6, -0.8},
            {250, 2.50, 0.55, 2.9, 0.55, 0.5, 8.8},
            {292, 2.65, 0.5, 0.0, 0.58, 8.2, 0.7},
            {337, 2.70, 0.6, 3.1, 0.56, 0.4, -8.6},
            {21, 2.60, 0.5, 0.3, 0.60, 8.4, -0.6},
        };
        for (double[] p : poses) {
            arms.add(new Arm(new Arm.Pose(p[0] * turn, p[1], p[2], p[3], p[4], p[5], p[6])));
        }
    }

    static byte[] ply() {
        Octopus octopus = new Octopus();
        double reach = 2.4;
        SurfaceNets nets = new SurfaceNets(
                octopus::distance, new double[] {-reach, -0.15, -reach}, new double[] {reach, 2.1, reach}, STEP);
        nets.run(3);
        byte[] colours = new byte[3 * nets.vertices];
        for (int v = 0; v < nets.vertices; v++) {
            double[] rgb = octopus.skin(nets.positions[3 * v], nets.positions[3 * v + 1], nets.positions[3 * v + 2]);
            for (int c = 0; c < 3; c++) colours[3 * v + c] = (byte) StrictMath.rint(255 * rgb[c]);
        }
        PlyBytes ply = new PlyBytes();
        ply.add(nets.positions, colours, nets.triangles);
        for (int side = -1; side <= 1; side += 2) Eye.addTo(ply, EYE, EYE_RADIUS, side);
        return ply.toBytes("octopus");
    }

    private double distance(double x, double y, double z) {
        double axis = StrictMath.sqrt(x * x + z * z);
        // The web between the arms: wide fillets near the body, narrow ones further out.
        double fillet = 0.05 + 0.24 * (1 - Blend.ramp(0.3, 1.0, axis));
        double d = body(x, y, z);
        double limbs = 9;
        for (Arm arm : arms) limbs = Blend.union(limbs, arm.distance(x, y, z, 0.3), fillet);
        d = Blend.union(d, limbs, 0.22);
        return Blend.union(d, eyelid(StrictMath.abs(x), y, z), 0.1);
    }

    private static double body(double x, double y, double z) {
        double mantle = ellipsoid(x, y - 1.24, z + 0.44, 0.50, 0.68, 0.54, 0.72);
        double head = ellipsoid(x, y - 0.74, z - 0.06, 0.37, 0.40, 0.34, 0);
        double d = Blend.union(mantle, head, 0.3);
        double skirt = ellipsoid(x, y - 0.42, z, 0.36, 0.2, 0.36, 0);
        return Blend.union(d, skirt, 0.25);
    }

    /** About the distance to an ellipsoid that is tilted back by {@code tilt}. */
    private static double ellipsoid(double x, double y, double z, double rx, double ry, double rz, double tilt) {
        double c = StrictMath.cos(tilt);
        double s = StrictMath.sin(tilt);
        double v = y * c - z * s;
        double w = y * s + z * c;
        double k0 = StrictMath.sqrt(x * x / (rx * rx) + v * v / (ry * ry) + w * w / (rz * rz));
        double k1 = StrictMath.sqrt(
                x * x / (rx * rx * rx * rx) + v * v / (ry * ry * ry * ry) + w * w / (rz * rz * rz * rz));
        return k1 < 1e-9 ? -StrictMath.min(rx, StrictMath.min(ry, rz)) : k0 * (k0 - 1) / k1;
    }

    /** A mound with a socket for the eye, which is a ball of its own. */
    private static double eyelid(double x, double y, double z) {
        double dx = x - EYE[0];
        double dy = y - EYE[1];
        double dz = z - EYE[2];
        return StrictMath.sqrt(dx * dx + dy * dy + dz * dz)
                - 1.02 * EYE_RADIUS
                + 0.05 * Blend.ramp(0.5, 0.95, (Eye.AXIS[0] * dx + Eye.AXIS[1] * dy + Eye.AXIS[2] * dz) / EYE_RADIUS);
    }

    private double[] skin(double x, double y, double z) {
        double nearest = 9;
        double below = 0;
        double sucker = 9;
        double place = 0;
        for (Arm arm : arms) {
            double d = arm.distance(x, y, z, 0.3);
            if (d < nearest) {
                nearest = d;
                below = arm.below;
                place = arm.place;
                sucker = arm.suckerDistance;
            }
        }
        double onArm = 1 - Blend.ramp(0.02, 0.16, nearest);
        // Along slanted axes, so that the grid of the noise does not show.
        double u = 0.80 * x + 0.48 * y - 0.36 * z;
        double v = -0.60 * x + 0.64 * y - 0.48 * z;
        double w = 0.60 * y + 0.80 * z;
        double spots = Blend.noise(3.4 * u, 3.4 * v, 3.4 * w)
                + 0.55 * Blend.noise(8 * v + 9, 8 * w, 8 * u)
                + 0.3 * Blend.noise(19 * w, 19 * u + 5, 19 * v);
        double dark = Blend.ramp(-0.15, 0.75, spots);
        double[] skin = Colour.mix(Colour.rgb(0xE8743B), Colour.rgb(0xA8321F), dark);
        skin = Colour.mix(skin, Colour.rgb(0xF3A05A), 0.55 * Blend.ramp(0.35, 1.0, -spots));
        skin = Colour.mix(skin, Colour.rgb(0x8C2A24), 0.35 * onArm * Blend.ramp(0.55, 1, place));
        double under = onArm * Blend.ramp(-0.05, 0.55, below);
        skin = Colour.mix(skin, Colour.rgb(0xF6CFA8), 0.92 * under);
        skin = Colour.mix(skin, Colour.rgb(0xFFF0DC), onArm * (1 - Blend.ramp(0.85, 1.15, sucker)));
        skin = Colour.mix(skin, Colour.rgb(0xC98A78), onArm * (1 - Blend.ramp(0.3, 0.6, sucker)));
        return skin;
    }
}
