package org.jsmesh.studio;

import java.util.List;

/**
 * The room of three.js's {@code RoomEnvironment}: white walls and six white boxes under a point light, and six panels
 * that shine. Lengths are in metres; y points up.
 */
final class Room {
    private static final double[] LAMP = {.418, 16.199, .3};
    private static final double LAMP_CANDELA = 900;
    private static final double LAMP_REACH = 28;
    /** Share of light from straight ahead that a wall reflects as a mirror does. */
    private static final double GLOSS = .04;

    private static final Box WALLS = box(-.757, 13.219, .717, 31.713, 28.305, 28.591, 0);

    private static final List<Box> BOXES = List.of(
            box(-10.906, 2.009, 1.846, 2.328, 7.905, 4.651, -.195),
            box(-5.607, -.754, -.758, 1.97, 1.534, 3.955, .994),
            box(6.167, .857, 7.803, 3.927, 6.285, 3.687, .561),
            box(-2.017, .018, 6.124, 2.002, 4.566, 2.064, .333),
            box(2.291, -.756, -2.621, 1.546, 1.552, 1.496, -.286),
            box(-2.193, -.369, -5.547, 3.875, 3.487, 2.986, .516));

    private static final List<Panel> PANELS = List.of(
            new Panel(box(-16.116, 14.37, 8.208, .1, 2.428, 2.739, 0), 50),
            new Panel(box(-16.109, 18.021, -8.207, .1, 2.425, 2.751, 0), 50),
            new Panel(box(14.904, 12.198, -1.832, .15, 4.265, 6.331, 0), 17),
            new Panel(box(-.462, 8.89, 14.52, 4.38, 5.441, .088, 0), 43),
            new Panel(box(3.235, 11.486, -12.541, 2.5, 2, .1, 0), 20),
            new Panel(box(0, 20, 0, 1, .1, 1, 0), 100));

    private record Panel(Box box, double radiance) {}

    private Room() {}

    private static Box box(double x, double y, double z, double width, double height, double depth, double turned) {
        return new Box(
                new double[] {x, y, z},
                new double[] {width / 2, height / 2, depth / 2},
                StrictMath.sin(turned),
                StrictMath.cos(turned));
    }

    /**
     * The light that comes to the origin from a direction.
     *
     * @param direction x, y, z of length 1
     * @return linear light; the walls below the lamp have about 1
     */
    static double radiance(double[] direction) {
        double nearest = WALLS.leave(direction); // some boxes reach through the floor
        double panel = -1;
        Box seen = WALLS;
        for (Panel p : PANELS) {
            double distance = p.box.enter(direction);
            if (distance >= nearest) continue;
            nearest = distance;
            panel = p.radiance;
        }
        for (Box box : BOXES) {
            double distance = box.enter(direction);
            if (distance >= nearest) continue;
            nearest = distance;
            panel = -1;
            seen = box;
        }
        if (panel >= 0) return panel;
        return reflected(direction, nearest, seen.normal(direction, nearest));
    }

    /** What a rough white surface that faces the origin sends there of the lamp's light. */
    private static double reflected(double[] direction, double distance, double[] normal) {
        double[] toLamp = new double[3];
        for (int k = 0; k < 3; k++) toLamp[k] = LAMP[k] - distance * direction[k];
        double length = Math.sqrt(dot(toLamp, toLamp));
        for (int k = 0; k < 3; k++) toLamp[k] /= length;
        double facingLamp = dot(normal, toLamp);
        if (facingLamp <= 0) return 0;
        double reach = length * length / (LAMP_REACH * LAMP_REACH);
        double near = Math.max(0, 1 - reach * reach);
        double irradiance = LAMP_CANDELA / (length * length) * near * near * facingLamp;
        double facingEye = Math.max(0, -dot(normal, direction));
        // The half vector is as far from the eye as from the lamp.
        double half = Math.sqrt(Math.max(0, (1 - dot(toLamp, direction)) / 2));
        double side = 1 - half;
        double fresnel = GLOSS + (1 - GLOSS) * side * side * side * side * side;
        return irradiance / Math.PI * (1 + fresnel / (2 * (facingLamp + facingEye)));
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
