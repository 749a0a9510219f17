package org.jsmesh.samples;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * The mechanical sample: a planetary gear set with double-helical teeth, sun 24, four planets of 18, ring 60, meshing
 * as they should. Module 1; the axis is z. Many creases, six materials, a normal per corner.
 */
final class PlanetaryGear {
    private static final int SUN = 24;
    private static final int PLANET = 18;
    private static final int RING = 60;
    private static final int PLANETS = 4;

    /** Half the width of the gears, and the sine-like slope of their teeth. */
    private static final double HALF = 4.5;

    private static final double SLOPE = 0.42;
    private static final double CHAMFER = 0.35;

    private static final String MATERIALS = """
            # Planetary gear set: steel, brass and anodised aluminium.
            newmtl blue-anodised
            Kd 0.2 0.4 0.64
            Ks 0.45 0.5 0.6
            Ns 60
            newmtl polished-steel
            Kd 0.74 0.76 0.79
            Ks 0.8 0.8 0.8
            Ns 160
            newmtl brass
            Kd 0.83 0.61 0.24
            Ks 0.8 0.7 0.4
            Ns 110
            newmtl red-anodised
            Kd 0.72 0.14 0.12
            Ks 0.5 0.4 0.4
            Ns 60
            newmtl black-oxide
            Kd 0.16 0.16 0.18
            Ks 0.4 0.4 0.4
            Ns 50
            newmtl bronze
            Kd 0.55 0.33 0.17
            Ks 0.6 0.45 0.3
            Ns 80
            """;

    private final ObjText obj = new ObjText("planetary gear set", "planetary-gear.mtl");

    private PlanetaryGear() {}

    static byte[] mtl() {
        return MATERIALS.getBytes(StandardCharsets.US_ASCII);
    }

    static byte[] obj() {
        PlanetaryGear gear = new PlanetaryGear();
        gear.housing();
        gear.carrier();
        gear.sun();
        Solid planet = planet();
        for (int i = 0; i < PLANETS; i++) {
            double direction = 2 * StrictMath.PI * i / PLANETS + StrictMath.PI / 4;
            double distance = 0.5 * (SUN + PLANET);
            double x = distance * StrictMath.cos(direction);
            double y = distance * StrictMath.sin(direction);
            // A gap of the planet faces a tooth of the sun, whose tooth 0 is at angle 0.
            double turn = direction + StrictMath.PI - StrictMath.PI / PLANET + direction * SUN / PLANET;
            gear.add("planet " + (i + 1), "brass", planet.placed(turn, x, y, 0));
            gear.add("bushing " + (i + 1), "bronze", bushing().placed(0, x, y, 0));
            gear.add("pin " + (i + 1), "polished-steel", pin().placed(0, x, y, 0));
        }
        return gear.obj.toBytes();
    }

    private void add(String name, String material, Solid solid) {
        obj.object(name.replace(' ', '-'), material);
        CreasedNormals normals = new CreasedNormals(solid.points, solid.triangles, 32);
        int[] ids = solid.points.stream().mapToInt(obj::position).toArray();
        for (int f = 0; f < solid.triangles.size(); f++) {
            int[] t = solid.triangles.get(f);
            int[] n = new int[3];
            for (int i = 0; i < 3; i++) n[i] = obj.normal(normals.at(f, t[i]));
            obj.triangle(new int[] {ids[t[0]], ids[t[1]], ids[t[2]]}, null, n);
        }
    }

    /**
     * The toothed wall, upwards when {@code up}, turned so that the helix of gears of any size runs alike;
     * {@code sense} is its hand.
     */
    private static void teeth(Solid solid, GearProfile profile, boolean up, int sense) {
        double[] heights = {-HALF, -HALF + CHAMFER, 0, HALF - CHAMFER, HALF};
        for (int i = 0; i < heights.length; i++) {
            double z = heights[up ? i : heights.length - 1 - i];
            double twist = sense * SLOPE * (HALF - StrictMath.abs(z)) / profile.pitch();
            boolean end = StrictMath.abs(z) == HALF;
            double most = end && up ? profile.tip() - CHAMFER : 9e9;
            double least = end && !up ? profile.root() + CHAMFER : 0;
            solid.loop(profile.outline(least, most), z, twist);
        }
    }

    private void housing() {
        int lobes = 8;
        Solid body = new Solid();
        double flange = -HALF + 2.2;
        body.loop(lobed(36.2, lobes), -HALF - 0.6).loop(lobed(36.6, lobes), -HALF - 0.2);
        body.loop(lobed(36.6, lobes), flange - 0.4).loop(lobed(36.2, lobes), flange);
        body.loop(Solid.circle(34.6, 112), flange).loop(Solid.circle(34.2, 112), flange + 0.4);
        body.loop(Solid.circle(34.2, 112), HALF - 1.6).loop(Solid.circle(33.7, 112), HALF - 1.4);
        body.loop(Solid.circle(33.7, 112), HALF - 1).loop(Solid.circle(34.2, 112), HALF - 0.8);
        body.loop(Solid.circle(34.2, 112), HALF + 0.2).loop(Solid.circle(33.8, 112), HALF + 0.6);
        body.loop(Solid.circle(32.4, 112), HALF + 0.6).loop(Solid.circle(32.1, 112), HALF);
        teeth(body, GearProfile.internal(RING), false, 1);
        body.loop(Solid.circle(32.4, 112), -HALF - 0.6).ring();
        double ringTurn = ringTurn();
        add("ring gear", "blue-anodised", body.placed(ringTurn, 0, 0, 0));
        for (int i = 0; i < lobes; i++) {
            double angle = 2 * StrictMath.PI * i / lobes + ringTurn;
            double x = 36.9 * StrictMath.cos(angle);
            double y = 36.9 * StrictMath.sin(angle);
            add("washer " + (i + 1), "polished-steel", washer().placed(0, x, y, flange));
            add("screw " + (i + 1), "black-oxide", screw().placed(0.3 + 0.7 * i, x, y, flange + 0.4));
        }
    }

    /** A space of the ring receives the tooth of the first planet that points at it. */
    private static double ringTurn() {
        double direction = StrictMath.PI / 4;
        double planet = direction + StrictMath.PI - StrictMath.PI / PLANET + direction * SUN / PLANET;
        return direction - (direction - planet) * PLANET / RING;
    }

    private static List<Solid.Polar> lobed(double radius, int lobes) {
        List<Solid.Polar> loop = new ArrayList<>();
        int count = 176;
        for (int i = 0; i < count; i++) {
            double angle = 2 * StrictMath.PI * i / count;
            double wave = 0.5 + 0.5 * StrictMath.cos(lobes * angle);
            loop.add(new Solid.Polar(radius + 3.2 * wave * wave * wave, angle));
        }
        return loop;
    }

    private static Solid washer() {
        return new Solid()
                .loop(Solid.circle(2.0, 32), 0)
                .loop(Solid.circle(2.0, 32), 0.4)
                .loop(Solid.circle(1.0, 24), 0.4)
                .loop(Solid.circle(1.0, 24), 0)
                .ring();
    }

    private static Solid screw() {
        return new Solid()
                .loop(Solid.circle(1.45, 30), 0)
                .loop(Solid.circle(1.45, 30), 1.5)
                .loop(Solid.circle(1.25, 30), 1.75)
                .loop(Solid.circle(0.85, 6), 1.75)
                .loop(Solid.circle(0.85, 6), 0.8)
                .tip(0.6)
                .bottom(0);
    }

    private void carrier() {
        double top = -HALF - 0.5;
        double low = top - 2.4;
        Solid plate = new Solid();
        plate.loop(rounded(26.6), low).loop(rounded(27.2), low + 0.6);
        plate.loop(rounded(27.2), top - 0.6).loop(rounded(26.6), top);
        plate.loop(Solid.circle(8.6, 64), top).loop(Solid.circle(8.2, 64), top - 0.4);
        plate.loop(Solid.circle(8.2, 64), low + 0.4)
                .loop(Solid.circle(8.6, 64), low)
                .ring();
        add("carrier", "red-anodised", plate);
    }

    /** A square with very round corners, one under each planet. */
    private static List<Solid.Polar> rounded(double radius) {
        List<Solid.Polar> loop = new ArrayList<>();
        int count = 128;
        for (int i = 0; i < count; i++) {
            double angle = 2 * StrictMath.PI * i / count;
            double wave = 0.5 - 0.5 * StrictMath.cos(PLANETS * angle);
            loop.add(new Solid.Polar(radius - 5.4 * (1 - wave) * (1 - wave), angle));
        }
        return loop;
    }

    private void sun() {
        Solid gear = new Solid();
        GearProfile profile = GearProfile.external(SUN);
        teeth(gear, profile, true, 1);
        gear.loop(Solid.circle(9.6, 72), HALF).loop(Solid.circle(9.3, 72), HALF - 0.9);
        gear.loop(Solid.circle(6.6, 48), HALF - 0.9).loop(Solid.circle(6.4, 48), HALF + 0.9);
        gear.loop(Solid.circle(6.1, 48), HALF + 1.2).loop(Solid.circle(4.6, 48), HALF + 1.2);
        gear.loop(Solid.circle(4.6, 48), -HALF).ring();
        add("sun", "polished-steel", gear);

        Solid shaft = new Solid();
        shaft.loop(Solid.circle(4.55, 48), -HALF - 6).loop(Solid.circle(4.55, 48), HALF + 1.6);
        shaft.loop(Solid.circle(4.2, 48), HALF + 2.0).loop(Solid.circle(3.8, 48), HALF + 2.0);
        shaft.loop(Solid.circle(3.8, 48), HALF + 2.6);
        shaft.loop(spline(3.75, 4.2), HALF + 2.6).loop(spline(3.75, 4.5), HALF + 3.0);
        shaft.loop(spline(3.75, 4.5), HALF + 8.4).loop(spline(3.75, 4.1), HALF + 8.8);
        shaft.loop(Solid.circle(3.4, 48), HALF + 8.8).loop(Solid.circle(3.2, 48), HALF + 9.4);
        shaft.loop(Solid.circle(1.5, 32), HALF + 9.4).loop(Solid.circle(0.8, 32), HALF + 8.2);
        shaft.tip(HALF + 7.6).bottom(-HALF - 6);
        add("shaft", "black-oxide", shaft);
    }

    /** Sixteen straight keys. */
    private static List<Solid.Polar> spline(double root, double tip) {
        List<Solid.Polar> loop = new ArrayList<>();
        int keys = 16;
        double step = 2 * StrictMath.PI / keys;
        for (int i = 0; i < keys; i++) {
            double centre = i * step;
            loop.add(new Solid.Polar(root, centre - 0.30 * step));
            loop.add(new Solid.Polar(tip, centre - 0.24 * step));
            loop.add(new Solid.Polar(tip, centre));
            loop.add(new Solid.Polar(tip, centre + 0.24 * step));
            loop.add(new Solid.Polar(root, centre + 0.30 * step));
        }
        return loop;
    }

    private static Solid planet() {
        Solid gear = new Solid();
        teeth(gear, GearProfile.external(PLANET), true, -1);
        gear.loop(Solid.circle(6.8, 60), HALF).loop(Solid.circle(6.5, 60), HALF - 0.8);
        gear.loop(Solid.circle(4.7, 40), HALF - 0.8).loop(Solid.circle(4.5, 40), HALF + 0.4);
        gear.loop(Solid.circle(3.5, 32), HALF + 0.4)
                .loop(Solid.circle(3.5, 32), -HALF)
                .ring();
        return gear;
    }

    private static Solid bushing() {
        return new Solid()
                .loop(Solid.circle(3.45, 32), -HALF)
                .loop(Solid.circle(3.45, 32), HALF + 0.6)
                .loop(Solid.circle(3.25, 32), HALF + 0.8)
                .loop(Solid.circle(2.4, 30), HALF + 0.8)
                .loop(Solid.circle(2.4, 30), -HALF)
                .ring();
    }

    private static Solid pin() {
        return new Solid()
                .loop(Solid.circle(2.35, 30), -HALF - 3.4)
                .loop(Solid.circle(2.35, 30), HALF + 1.3)
                .loop(Solid.circle(1.95, 30), HALF + 1.7)
                .loop(Solid.circle(0.9, 24), HALF + 1.7)
                .loop(Solid.circle(0.5, 24), HALF + 1.1)
                .tip(HALF + 0.9)
                .bottom(-HALF - 3.4);
    }
}
