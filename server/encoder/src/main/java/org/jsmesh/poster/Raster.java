package org.jsmesh.poster;

import org.jsmesh.display.RenderMesh;

/**
 * Finds the samples of the picture that a face covers. Corners lie on a grid of 256ths of a sample, so that every
 * sample at an edge belongs to one of the two faces beside it and no sum is rounded.
 */
final class Raster {
    private static final int UNIT = 256;
    private static final double MOST = 1 << 22;

    final int width;
    final int height;
    private final int[] x;
    private final int[] y;
    /** One over the depth of each vertex; 0 where it is too near to be drawn. */
    private final double[] nearness;

    private final int[] indices;

    /** Is told of each sample of a face. */
    interface Visitor {
        /** @param a share of the face's first corner on the picture; those of the others are b and c */
        void visit(int sample, double a, double b, double c);
    }

    /** @param placed positions in the space of the view */
    Raster(RenderMesh mesh, float[] placed, View view, int width, int height) {
        this.width = width;
        this.height = height;
        indices = mesh.indices();
        int count = placed.length / 3;
        x = new int[count];
        y = new int[count];
        nearness = new double[count];
        for (int v = 0; v < count; v++) {
            double depth = view.depth(placed, 3 * v);
            if (depth == 0) continue;
            nearness[v] = 1 / depth;
            x[v] = fixed((.5 + .5 * view.across(placed, 3 * v, depth)) * width);
            y[v] = fixed((.5 - .5 * view.upwards(placed, 3 * v, depth)) * height);
        }
    }

    private static int fixed(double samples) {
        return (int) Math.floor(Math.max(-MOST, Math.min(MOST, samples * UNIT)) + .5);
    }

    double nearness(int vertex) {
        return nearness[vertex];
    }

    /** Twice the area of a face in samples: positive where it is seen from the front. */
    double area(int face) {
        return -doubleArea(face) / ((double) UNIT * UNIT);
    }

    private long doubleArea(int face) {
        int a = indices[3 * face];
        int b = indices[3 * face + 1];
        int c = indices[3 * face + 2];
        return (long) (x[b] - x[a]) * (y[c] - y[a]) - (long) (x[c] - x[a]) * (y[b] - y[a]);
    }

    /** Shares of a face's corners at a sample. */
    void shares(int face, int sample, double[] shares) {
        int a = indices[3 * face];
        int b = indices[3 * face + 1];
        int c = indices[3 * face + 2];
        double scale = 1.0 / doubleArea(face);
        shares[0] = edge(b, c, sample % width, sample / width) * scale;
        shares[1] = edge(c, a, sample % width, sample / width) * scale;
        shares[2] = edge(a, b, sample % width, sample / width) * scale;
    }

    /** Changes of the shares of corners 1 and 2 from sample to sample: across, then down. */
    void slopes(int face, double[] slopes) {
        int a = indices[3 * face];
        int b = indices[3 * face + 1];
        int c = indices[3 * face + 2];
        double unit = (double) UNIT / doubleArea(face);
        slopes[0] = (y[c] - y[a]) * unit;
        slopes[1] = -(y[b] - y[a]) * unit;
        slopes[2] = -(x[c] - x[a]) * unit;
        slopes[3] = (x[b] - x[a]) * unit;
    }

    /** Samples that a visit to a face looks at, about. */
    long samples(int face) {
        int a = indices[3 * face];
        int b = indices[3 * face + 1];
        int c = indices[3 * face + 2];
        if (nearness[a] == 0 || nearness[b] == 0 || nearness[c] == 0) return 1;
        int left = first(Math.min(x[a], Math.min(x[b], x[c])));
        int right = Math.min(width - 1, last(Math.max(x[a], Math.max(x[b], x[c]))));
        int top = first(Math.min(y[a], Math.min(y[b], y[c])));
        int bottom = Math.min(height - 1, last(Math.max(y[a], Math.max(y[b], y[c]))));
        return 1 + Math.max(0, right - left + 1L) * Math.max(0, bottom - top + 1L);
    }

    void visit(int face, Visitor visitor) {
        int a = indices[3 * face];
        int b = indices[3 * face + 1];
        int c = indices[3 * face + 2];
        if (nearness[a] == 0 || nearness[b] == 0 || nearness[c] == 0) return;
        long area = doubleArea(face);
        if (area == 0) return;
        long sign = area < 0 ? -1 : 1;
        int left = first(Math.min(x[a], Math.min(x[b], x[c])));
        int right = Math.min(width - 1, last(Math.max(x[a], Math.max(x[b], x[c]))));
        int top = first(Math.min(y[a], Math.min(y[b], y[c])));
        int bottom = Math.min(height - 1, last(Math.max(y[a], Math.max(y[b], y[c]))));
        if (left > right || top > bottom) return;
        long stepA = sign * (y[b] - y[c]);
        long stepB = sign * (y[c] - y[a]);
        long stepC = sign * (y[a] - y[b]);
        long leastA = isFirst(stepA, sign * (x[c] - x[b])) ? 0 : 1;
        long leastB = isFirst(stepB, sign * (x[a] - x[c])) ? 0 : 1;
        long leastC = isFirst(stepC, sign * (x[b] - x[a])) ? 0 : 1;
        double scale = 1.0 / Math.abs(area);
        for (int row = top; row <= bottom; row++) {
            long ofA = sign * edge(b, c, left, row);
            long ofB = sign * edge(c, a, left, row);
            long ofC = sign * edge(a, b, left, row);
            for (int column = left; column <= right; column++) {
                if (ofA >= leastA && ofB >= leastB && ofC >= leastC)
                    visitor.visit(row * width + column, ofA * scale, ofB * scale, ofC * scale);
                ofA += stepA * UNIT;
                ofB += stepB * UNIT;
                ofC += stepC * UNIT;
            }
        }
    }

    /** Twice the signed area of an edge and the middle of a sample. */
    private long edge(int from, int to, int column, int row) {
        long px = (long) column * UNIT + UNIT / 2;
        long py = (long) row * UNIT + UNIT / 2;
        return (x[to] - x[from]) * (py - y[from]) - (y[to] - y[from]) * (px - x[from]);
    }

    /** Does a sample on an edge belong to the face? Of two faces beside an edge, one says yes. */
    private static boolean isFirst(long across, long down) {
        return across > 0 || across == 0 && down > 0;
    }

    /** The first column or row whose middle is at or beyond a place. */
    private static int first(int place) {
        return Math.max(0, Math.floorDiv(place + UNIT / 2 - 1, UNIT));
    }

    private static int last(int place) {
        return Math.floorDiv(place - UNIT / 2, UNIT);
    }
}
