package org.jsmesh.encode.measure;

/** A grid of cells, each with the points whose reach goes into it. */
final class PointGrid {
    private static final int MOST_CELLS = 96; // per axis

    /** Places of points in cells for which the cells are made larger, where few points reach far and most do not. */
    private static final long MANY_PLACES = 1 << 22;

    private final double[] low = new double[3];
    private final int[] cells = new int[3];
    private double perLength; // cells
    private final int[] starts; // of each cell's items
    private final int[] items;

    /**
     * @param points x, y, z of each
     * @param chosen numbers of the points that count, at least one
     * @param reach of every point
     */
    PointGrid(double[] points, int[] chosen, double[] reach) {
        double longest = 0;
        double[] side = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i : chosen) {
                least = Math.min(least, points[3 * i + axis] - reach[i]);
                most = Math.max(most, points[3 * i + axis] + reach[i]);
            }
            low[axis] = least;
            side[axis] = most - least;
            longest = Math.max(longest, side[axis]);
        }
        double meanReach = 0;
        for (int i : chosen) meanReach += reach[i] / chosen.length;
        // a point is then in few cells, and a cell has few points where the reach allows it
        double inCells = meanReach > 0 ? longest / meanReach : 1;
        int most = (int) Math.max(1, Math.min(Math.min(MOST_CELLS, 2 + Math.sqrt(chosen.length)), inCells));
        while (true) {
            perLength = longest > 0 ? most / longest : 0;
            for (int axis = 0; axis < 3; axis++) cells[axis] = Math.min(most, 1 + (int) (side[axis] * perLength));
            if (most == 1 || places(points, chosen, reach) <= MANY_PLACES) break;
            most /= 2;
        }
        int[] counts = new int[cells[0] * cells[1] * cells[2] + 1];
        visit(points, chosen, reach, counts, null);
        int total = 0;
        for (int i = 0; i < counts.length; i++) {
            int n = counts[i];
            counts[i] = total;
            total += n;
        }
        starts = counts.clone();
        items = new int[total];
        visit(points, chosen, reach, counts, items);
    }

    private long places(double[] points, int[] chosen, double[] reach) {
        long places = 0;
        for (int i : chosen) {
            long cells = 1;
            for (int axis = 0; axis < 3; axis++) {
                double x = points[3 * i + axis];
                cells *= last(axis, x + reach[i]) - first(axis, x - reach[i]) + 1;
            }
            places += cells;
        }
        return places;
    }

    /** Counts the points of each cell, or puts them into the cells. */
    private void visit(double[] points, int[] chosen, double[] reach, int[] at, int[] list) {
        for (int i : chosen) {
            double r = reach[i];
            int x1 = last(0, points[3 * i] + r);
            int y1 = last(1, points[3 * i + 1] + r);
            int z1 = last(2, points[3 * i + 2] + r);
            for (int z = first(2, points[3 * i + 2] - r); z <= z1; z++) {
                for (int y = first(1, points[3 * i + 1] - r); y <= y1; y++) {
                    for (int x = first(0, points[3 * i] - r); x <= x1; x++) {
                        int cell = cell(x, y, z);
                        if (list != null) list[at[cell]] = i;
                        at[cell]++;
                    }
                }
            }
        }
    }

    /** The first cell along an axis that is not before a coordinate; beyond the last one where there is none. */
    int first(int axis, double coordinate) {
        double cell = (coordinate - low[axis]) * perLength;
        return cell <= 0 ? 0 : (int) Math.min(cell, cells[axis] - (cell > cells[axis] + 1 ? 0 : 1));
    }

    /** The last cell along an axis that is not behind a coordinate; −1 where there is none. */
    int last(int axis, double coordinate) {
        double cell = (coordinate - low[axis]) * perLength;
        return cell < -1 ? -1 : (int) Math.max(0, Math.min(cell, cells[axis] - 1));
    }

    int cell(int x, int y, int z) {
        return (z * cells[1] + y) * cells[0] + x;
    }

    /** First place of a cell in the {@link #items}; they end at the first place of the next cell. */
    int[] starts() {
        return starts;
    }

    int[] items() {
        return items;
    }

    /** Longest side of the box of some points, at least a little. */
    static double extent(double[] points) {
        double extent = Double.MIN_NORMAL;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < points.length; i += 3) {
                low = Math.min(low, points[i]);
                high = Math.max(high, points[i]);
            }
            extent = Math.max(extent, high - low);
        }
        return extent;
    }
}
