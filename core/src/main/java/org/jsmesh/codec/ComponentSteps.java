package org.jsmesh.codec;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.codec.entropy.IntegerLog;
import org.jsmesh.codec.lod.LodMesh;

/**
 * Measures how far components that come after the base lie from what was there: about the distance from the closest
 * vertex, hardly less. It looks in hashed grids of growing blocks, in the smallest ones around the vertex that hold any
 * vertex.
 */
final class ComponentSteps {
    private static final int MOST_IN_BLOCK = 8;
    private static final int MOST_MEASURED = 4096; // components of a pass
    private static final int COARSEST = 31; // bits
    private final LodMesh mesh;
    private final SplitSteps steps;
    private final List<int[]> grids =
            new ArrayList<>(); // the grid of twice the block after each: where its lists begin, the
    // end of the last, and then the vertices by list
    private int fans; // before the pass
    private int finest; // bits of the smallest block
    private int stride;
    private int come;

    ComponentSteps(LodMesh mesh, SplitSteps steps) {
        this.mesh = mesh;
        this.steps = steps;
    }

    /** A pass with so many components begins. */
    void begin(int components) {
        grids.clear();
        stride = 1 + components / MOST_MEASURED;
        come = 0;
        fans = mesh.fans();
    }

    /** No more components come in the pass. */
    void end() {
        grids.clear();
    }

    /** A component has come; its vertices are the last ones. */
    void add(int firstFan) {
        if (come++ % stride > 0) return;
        if (grids.isEmpty()) findFinest();
        double wide = 0;
        for (int fan = firstFan + 1; fan < mesh.fans(); fan++) wide = Math.max(wide, squared(firstFan, fan));
        steps.add(Math.sqrt(nearest(firstFan)) + Math.sqrt(wide));
    }

    private void findFinest() {
        int[] cells = mesh.places();
        double longest = 0;
        for (int a = 0; a < 3; a++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int v = 0; v < fans; v++) {
                low = Math.min(low, cells[4 * v + a]);
                high = Math.max(high, cells[4 * v + a]);
            }
            longest = Math.max(longest, high - low);
        }
        finest = Math.min(COARSEST, IntegerLog.bits((int) (longest / Math.sqrt(fans))));
    }

    /** The squared distance from the closest vertex in the smallest blocks that have one. */
    private double nearest(int fan) {
        int[] cells = mesh.places();
        for (int bits = finest; bits <= COARSEST; bits++) {
            int[] grid = grid(bits);
            double least = Double.POSITIVE_INFINITY;
            for (int i = 0; i < 27; i++) {
                int x = (cells[4 * fan] >> bits) + i % 3 - 1;
                int y = (cells[4 * fan + 1] >> bits) + i / 3 % 3 - 1;
                int z = (cells[4 * fan + 2] >> bits) + i / 9 - 1;
                int list = list(x, y, z);
                for (int k = grid[list]; k < grid[list + 1]; k++) least = Math.min(least, squared(fan, grid[k]));
            }
            double block = (double) (1L << bits);
            if (least <= 12 * block * block) return least; // else it is of another block with the same hash
        }
        return squared(fan, 0);
    }

    private int[] grid(int bits) {
        int number = bits - finest;
        while (grids.size() <= number) grids.add(null);
        if (grids.get(number) == null) grids.set(number, makeGrid(bits));
        return grids.get(number);
    }

    private int[] makeGrid(int bits) {
        int[] starts = new int[(1 << Math.min(18, 1 + IntegerLog.bits(fans))) + 1];
        for (int v = 0; v < fans; v++) {
            int list = 1 + list(v, bits);
            starts[list] = Math.min(starts[list] + 1, MOST_IN_BLOCK);
        }
        starts[0] = starts.length;
        for (int list = 1; list < starts.length; list++) starts[list] += starts[list - 1];
        int[] grid = Arrays.copyOf(starts, starts[starts.length - 1]);
        Arrays.fill(grid, starts.length, grid.length, -1);
        for (int v = 0; v < fans; v++) {
            int list = list(v, bits);
            int k = starts[list];
            while (k < starts[list + 1] && grid[k] >= 0) k++;
            if (k < starts[list + 1]) grid[k] = v;
        }
        return grid;
    }

    private int list(int fan, int bits) {
        int[] cells = mesh.places();
        return list(cells[4 * fan] >> bits, cells[4 * fan + 1] >> bits, cells[4 * fan + 2] >> bits);
    }

    private int list(int x, int y, int z) {
        int hash = ((x * 0x9e3779b1 + y) * 0x9e3779b1 + z) * 0x9e3779b1 >>> 8;
        return hash & (1 << Math.min(18, 1 + IntegerLog.bits(fans))) - 1;
    }

    private double squared(int a, int b) {
        int[] cells = mesh.places();
        double x = (double) cells[4 * a] - cells[4 * b];
        double y = (double) cells[4 * a + 1] - cells[4 * b + 1];
        double z = (double) cells[4 * a + 2] - cells[4 * b + 2];
        return x * x + y * y + z * z;
    }
}
