package org.jsmesh.desktop.draw;

/** A face whose sides are cut into equal parts; one that is not cut has its middle measured. */
final class CutFace {
    private final int cuts;
    private final float[] corners = new float[9];
    private final float[] points;

    CutFace(int cuts) {
        this.cuts = cuts;
        points = new float[cuts == 1 ? 3 : 3 * (cuts + 1) * (cuts + 2) / 2];
    }

    void corner(int k, float[] positions, int vertex) {
        System.arraycopy(positions, 3 * vertex, corners, 3 * k, 3);
    }

    /** Points to be measured, three coordinates each; the next call overwrites them. */
    float[] points() {
        int n = 0;
        for (int row = 0; row <= cuts && cuts > 1; row++) {
            for (int column = 0; column <= cuts - row; column++) {
                double u = (double) column / cuts;
                double v = (double) row / cuts;
                for (int axis = 0; axis < 3; axis++)
                    points[n++] = (float) (corners[axis] * (1 - u - v) + corners[3 + axis] * u + corners[6 + axis] * v);
            }
        }
        if (cuts == 1)
            for (int axis = 0; axis < 3; axis++)
                points[axis] = (corners[axis] + corners[3 + axis] + corners[6 + axis]) / 3;
        return points;
    }

    /**
     * Writes the triangles.
     *
     * @param measured distances of the points
     * @param to the first corner to write
     * @return the one behind the last
     */
    int write(float[] measured, float[] positions, float[] distances, int to) {
        int at = to;
        if (cuts == 1) {
            System.arraycopy(corners, 0, positions, 3 * at, 9);
            for (int k = 0; k < 3; k++) distances[at++] = measured[0];
            return at;
        }
        int first = 0;
        for (int row = 0; row < cuts; row++) {
            int above = first + cuts - row + 1;
            for (int column = 0; column < cuts - row; column++) {
                int left = first + column;
                int up = above + column;
                at = triangle(left, left + 1, up, measured, positions, distances, at);
                if (column < cuts - row - 1) at = triangle(left + 1, up + 1, up, measured, positions, distances, at);
            }
            first = above;
        }
        return at;
    }

    private int triangle(int a, int b, int c, float[] measured, float[] positions, float[] distances, int to) {
        int at = to;
        for (int point : new int[] {a, b, c}) {
            System.arraycopy(points, 3 * point, positions, 3 * at, 3);
            distances[at++] = measured[point];
        }
        return at;
    }
}
