package org.jsmesh.studio;

import java.util.Arrays;

/**
 * How dark the ground beneath a model is: the nearer the model comes to it, the darker, and soft. It is the same on
 * page, poster and in the window. The model lies in a space where y points up and its bounding box is centred at the
 * origin.
 */
public final class ContactShadow {
    /** Cells across, and along. */
    public static final int SIDE = 96;

    /** How dark the ground is at most. */
    public static final float DARKEST = .75f;

    /** Of larger models only a part is looked at: their triangles are small. */
    private static final int TRIANGLES = 50_000;

    /** Places after which only few of each further triangle are looked at: thousands of large ones hide each other. */
    private static final int MANY_PLACES = 1 << 24;

    private static final int FEW_STEPS = 6;

    /** The side of the ground in lengths of the model's longer side. */
    private static final double SPACE = 1.6;

    /** Height at which the shadow is less than half as dark, in lengths of the model's longest side. */
    private static final double REACH = .08;

    /** Of the cells around one, in the blur: its deviation is four cells. */
    private static final float[] WEIGHTS = new float[25];

    static {
        for (int i = 0; i < WEIGHTS.length; i++) WEIGHTS[i] = (float) (StrictMath.exp(-(i - 12) * (i - 12) / 32.) / 10);
    }

    private final byte[] cells;
    private final double half;
    private final double height;

    private ContactShadow(byte[] cells, double half, double height) {
        this.cells = cells;
        this.half = half;
        this.height = height;
    }

    /**
     * Casts a shadow.
     *
     * @param positions x, y, z of each vertex
     * @param indices of the corners of triangles
     * @param halfX half the width of the model
     * @param halfY half its height
     * @param halfZ half its depth
     * @return the shadow
     */
    public static ContactShadow of(float[] positions, int[] indices, double halfX, double halfY, double halfZ) {
        double half = SPACE * Math.max(halfX, halfZ);
        if (half == 0) half = .5;
        double reach = 2 * REACH * Math.max(Math.max(halfX, halfY), halfZ);
        if (reach == 0) reach = 1;
        float[] lowest = new float[SIDE * SIDE]; // height above each cell, in reaches
        Arrays.fill(lowest, 99);
        double[] p = new double[9];
        int places = 0;
        int stride = 3 * Math.max(1, (indices.length / 3 + TRIANGLES - 1) / TRIANGLES);
        for (int i = 0; i < indices.length; i += stride) {
            for (int corner = 0; corner < 3; corner++) {
                int at = 3 * indices[i + corner];
                p[3 * corner] = (positions[at] / half + 1) / 2 * SIDE;
                p[3 * corner + 1] = (positions[at + 2] / half + 1) / 2 * SIDE;
                p[3 * corner + 2] = (positions[at + 1] + halfY) / reach;
            }
            int steps = places < MANY_PLACES ? steps(p) : Math.min(FEW_STEPS, steps(p));
            places += (steps + 1) * (steps + 2) / 2;
            cover(lowest, p, steps);
        }
        float[] dark = new float[lowest.length];
        for (int i = 0; i < dark.length; i++) dark[i] = (float) StrictMath.exp(-Math.max(0, lowest[i]));
        dark = blurred(blurred(dark, 1), SIDE);
        byte[] cells = new byte[dark.length];
        for (int i = 0; i < cells.length; i++) cells[i] = (byte) (255 * dark[i] + .5);
        return new ContactShadow(cells, half, -halfY);
    }

    /** More places along the longest side of a triangle than it crosses cells. */
    private static int steps(double[] p) {
        double most = extent(p, 0) + extent(p, 1);
        return (int) Math.max(1, Math.min(2 * SIDE, Math.ceil(1.4 * most)));
    }

    /** Looks at places of a triangle. */
    private static void cover(float[] lowest, double[] p, int steps) {
        for (int b = 0; b <= steps; b++) {
            for (int c = 0; b + c <= steps; c++) {
                double u = (double) b / steps;
                double v = (double) c / steps;
                double w = 1 - u - v;
                double across = w * p[0] + u * p[3] + v * p[6];
                double along = w * p[1] + u * p[4] + v * p[7];
                if (!(across >= 0 && along >= 0 && across < SIDE && along < SIDE)) continue;
                int cell = (int) along * SIDE + (int) across;
                lowest[cell] = Math.min(lowest[cell], (float) (w * p[2] + u * p[5] + v * p[8]));
            }
        }
    }

    private static double extent(double[] p, int axis) {
        double most = Math.max(p[axis], Math.max(p[axis + 3], p[axis + 6]));
        return most - Math.min(p[axis], Math.min(p[axis + 3], p[axis + 6]));
    }

    /** Blurs one direction. The cells of the edge are light, so a row may go on in the next one. */
    private static float[] blurred(float[] dark, int step) {
        float[] result = new float[dark.length];
        for (int cell = 0; cell < dark.length; cell++) {
            double sum = 0;
            for (int i = 0; i < WEIGHTS.length; i++) {
                int other = cell + (i - WEIGHTS.length / 2) * step;
                if (other >= 0 && other < dark.length) sum += WEIGHTS[i] * dark[other];
            }
            result[cell] = (float) sum;
        }
        return result;
    }

    /**
     * Half the side of the square that may be dark.
     *
     * @return in the units of the model
     */
    public double half() {
        return half;
    }

    /**
     * The height of the ground.
     *
     * @return y of the model's lowest point
     */
    public double height() {
        return height;
    }

    /**
     * How dark each cell is, in rows from small z to large z.
     *
     * @return bytes of 0 to 255, 0 for light
     */
    public byte[] cells() {
        return cells.clone();
    }

    /**
     * The share of light that the ground keeps from the eye, between the cells as a graphics card reckons it.
     *
     * @param x place on the ground
     * @param z place on the ground
     * @return 0 to {@value #DARKEST}
     */
    public double at(double x, double z) {
        if (Math.abs(x) > half || Math.abs(z) > half) return 0;
        double across = Math.max(0, Math.min(SIDE - 1, (x / half + 1) / 2 * SIDE - .5));
        double along = Math.max(0, Math.min(SIDE - 1, (z / half + 1) / 2 * SIDE - .5));
        int column = Math.min((int) across, SIDE - 2);
        int row = Math.min((int) along, SIDE - 2);
        double above = between(row * SIDE + column, across - column);
        double below = between((row + 1) * SIDE + column, across - column);
        return DARKEST * (above + (along - row) * (below - above)) / 255;
    }

    private double between(int cell, double part) {
        int left = cells[cell] & 255;
        int right = cells[cell + 1] & 255;
        return left + part * (right - left);
    }
}
