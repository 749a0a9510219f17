package org.jsmesh.studio;

/**
 * The light from all sides, as surfaces of growing roughness mirror it. The room is blurred a little, then again and
 * again; the steps are those of three.js 0.181 ({@code PMREMGenerator}), so that the window shows what the page shows.
 * The light of matte surfaces is that of the last level.
 */
public final class Studio {
    /** Levels of blur, from the sharpest on. */
    public static final int LEVELS = 10;

    /** Pixels a side of each level, with a border of one pixel, so that filters find the neighbours beyond the edge. */
    public static final int SIDE = 130;

    /** Pixels a side of the cubes on which the levels are blurred. */
    private static final int[] SIZES = {128, 64, 32, 16};

    private static final double SHARPEST = .04;
    private static final int TAPS = 128;

    private Studio() {}

    /**
     * Computes the light; that takes about a fifth of a second.
     *
     * @return linear light, of one number per pixel as all lamps are white; level by level, each row by row as
     *     {@code SphereMap} says
     */
    public static float[] light() {
        float[] all = new float[LEVELS * SIDE * SIDE];
        CubePicture picture = Softening.of(CubePicture.drawn(SIZES[0], Room::radiance), SIZES[0], SHARPEST);
        for (int level = 0; level < LEVELS; level++) {
            if (level > 0) picture = blurred(picture, level);
            SphereMap fine = SphereMap.of(SIDE - 2, picture::at);
            for (int i = 0; i < SIDE * SIDE; i++) all[level * SIDE * SIDE + i] = fine.pixel(i % SIDE - 1, i / SIDE - 1);
        }
        return all;
    }

    private static CubePicture blurred(CubePicture picture, int level) {
        Taps taps = Taps.reflections(TAPS, alpha(level));
        return CubePicture.of(SIZES[Math.min(level, SIZES.length - 1)], direction -> taps.mean(picture, direction));
    }

    /** Of the blur from a level to the next one. */
    private static double alpha(int level) {
        double whole = (double) level / (LEVELS - 1);
        double before = (level - 1.0) / (LEVELS - 1);
        double step = Math.sqrt(whole * whole - before * before) * (.05 + .95 * whole);
        return step * step;
    }
}
