package org.jsmesh.encode.measure;

import java.util.Arrays;

/**
 * Chooses the units at whose middles vertices are shown, such that points come close to the triangles between them.
 * Vertex after vertex takes the best unit of its own and those about it, given the others; so neighbours make up for
 * each other's rounding. A unit that does not hold the place to which the vertex comes next costs bits then. It is
 * taken only where the surface comes closer by enough.
 */
final class PlaceChoice {
    private static final int ROUNDS = 3;

    /** Bits that a coordinate costs more when its next place is in the unit beside. */
    private static final double BITS_BESIDE = 2.5;

    /** What a bit is worth, in parts of the sum of squares per vertex. */
    private static final double WORTH_OF_BIT = 0.5;

    private static final int AROUND = 27; // units that are compared
    private static final int OWN = 13; // the one in the middle of them

    private final PointEquations equations;
    private final double stay;
    private final UnitGrid grid;
    private final double[] x;
    private final int[] units;
    private final int[] next;
    private final double[] slope;
    private final double[] blocks; // xx, xy, xz, yy, yz, zz of the second derivatives by each vertex
    private final int[] first; // by vertex: its first corner in the list
    private final int[] corners; // three times the row, plus the corner
    private final double[] step = new double[3];
    private double worthOfBit;

    /**
     * @param x positions of the vertices, as they would be best; changed
     * @param stay weight of a vertex's start, as for {@link PointEquations#solve}
     * @param next units that hold the next places of the vertices
     */
    PlaceChoice(PointEquations equations, double[] x, double stay, UnitGrid grid, int[] next) {
        this.equations = equations;
        this.x = x;
        this.grid = grid;
        this.next = next;
        this.stay = equations.weightOfStart(x.length, stay);
        units = new int[x.length];
        for (int i = 0; i < x.length; i++) {
            units[i] = grid.cell(x[i], i % 3) >> grid.shift();
            x[i] = grid.middle(units[i], i % 3);
        }
        corners = new int[equations.corners()];
        first = new int[x.length / 3 + 1];
        for (int i = 0; i < corners.length; i++) first[equations.vertex(i) + 1]++;
        for (int v = 1; v < first.length; v++) first[v] += first[v - 1];
        int[] at = Arrays.copyOf(first, first.length - 1);
        for (int i = 0; i < corners.length; i++) corners[at[equations.vertex(i)]++] = i;
        slope = equations.slope(x, this.stay);
        blocks = equations.blocks(x.length / 3, this.stay);
    }

    /** Returns three units per vertex. */
    int[] choose() {
        worthOfBit = WORTH_OF_BIT * equations.square(x) / (x.length / 3.0);
        boolean improved = true;
        for (int round = 0; round < ROUNDS && improved; round++) {
            improved = false;
            for (int v = 0; v < x.length / 3; v++) improved |= improve(v);
        }
        return units;
    }

    private boolean improve(int vertex) {
        int at = 3 * vertex;
        int chosen = OWN;
        double best = worthOfBit * bits(at, OWN);
        for (int i = 0; i < AROUND; i++) {
            if (i == OWN) continue;
            double cost = change(at, i) + worthOfBit * bits(at, i);
            if (cost >= best) continue;
            best = cost;
            chosen = i;
        }
        if (chosen == OWN) return false;
        go(at, chosen);
        return true;
    }

    /** By how many units the place with a number among those around is off along an axis. */
    private static int off(int number, int axis) {
        return (axis == 0 ? number % 3 : axis == 1 ? number / 3 % 3 : number / 9) - 1;
    }

    private double change(int at, int number) {
        double unit = grid.unitSize();
        double dx = off(number, 0) * unit;
        double dy = off(number, 1) * unit;
        double dz = off(number, 2) * unit;
        int b = 2 * at;
        double square = blocks[b] * dx * dx + blocks[b + 3] * dy * dy + blocks[b + 5] * dz * dz;
        double mixed = blocks[b + 1] * dx * dy + blocks[b + 2] * dx * dz + blocks[b + 4] * dy * dz;
        return slope[at] * dx + slope[at + 1] * dy + slope[at + 2] * dz + square / 2 + mixed;
    }

    private double bits(int at, int number) {
        double bits = 0;
        for (int a = 0; a < 3; a++) {
            int beside = Math.abs(units[at + a] + off(number, a) - next[at + a]);
            if (beside > 0) bits += BITS_BESIDE + StrictMath.log(beside) / StrictMath.log(2);
        }
        return bits;
    }

    private void go(int at, int number) {
        for (int a = 0; a < 3; a++) {
            units[at + a] += off(number, a);
            step[a] = off(number, a) * grid.unitSize();
            x[at + a] = grid.middle(units[at + a], a);
            slope[at + a] += stay * step[a];
        }
        for (int i = first[at / 3]; i < first[at / 3 + 1]; i++) equations.addSlope(slope, corners[i], step);
    }
}
