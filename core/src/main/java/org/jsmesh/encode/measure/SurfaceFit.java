package org.jsmesh.encode.measure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;
import org.jsmesh.mesh.Mesh;

/**
 * Moves the vertices of coarse levels so that points of the original come close to all of their surfaces, by least
 * squares, as Hoppe et al. 1993, 'Mesh optimization', do it for one mesh. Distances count along the normals of the
 * surfaces, as Chen and Medioni 1992, 'Object modelling by registration of multiple range images', measure them. So
 * vertices need not slide along the surface, and few rounds are enough. Deterministic.
 */
public final class SurfaceFit {
    private static final int ROUNDS = 2;

    /** Of conjugate gradients. */
    private static final int STEPS = 12;

    private static final int POINTS_PER_VERTEX = 3;

    private static final int STREWN = 3;

    /** Unless the original has few vertices. */
    private static final int FEWEST_POINTS = 4000;

    private static final int POINTS_OF_ERROR = 2000;

    /** Weight of a vertex's own position, in parts of the weight of its points. */
    private static final double STAY = 0.25;

    /** The same while places are chosen, where most units about a vertex are further away than its move. */
    private static final double STAY_OF_PLACE = 0.05;

    /**
     * Power of a level's error in the weight of the level. With 2, all levels would improve by the same share if points
     * alone counted. A smaller power favours coarse levels.
     */
    private static final double POWER_OF_ERROR = -1.9;

    private final StageProgress stages;
    private final Mesh original;
    private final SurfacePoints surface;
    private int[] number; // of each vertex of the original among those of all levels, or −1
    private double[] start; // of the vertices of all levels
    private double[] fitted;
    private PointEquations equations; // of the last round
    private final ClosestPoint closest = new ClosestPoint();
    private boolean isCrowded; // a level was; then others are not even tried

    /**
     * @param surface of the original
     * @param stages hears of every fit
     */
    public SurfaceFit(Mesh original, SurfacePoints surface, StageProgress stages) {
        this.stages = stages;
        this.original = original;
        this.surface = surface;
    }

    /**
     * Fits levels of detail to the original.
     *
     * @param levels three vertices of the original per triangle, finest level first
     * @param unit length in which to measure moves
     * @return the moves of all vertices along x, y, z, in units
     */
    public int[] fit(List<int[]> levels, double unit) {
        return stages.during("fitting", () -> {
            fitAll(levels);
            return moves(i -> (int) Math.rint((fitted[i] - start[i]) / unit));
        });
    }

    /**
     * The same with all vertices of the levels at places of a grid.
     *
     * @return the moves of all vertices along x, y, z, in cells
     */
    public int[] fit(List<int[]> levels, UnitGrid grid) {
        return stages.during("fitting", () -> {
            fitAll(levels);
            int[] next = new int[fitted.length];
            for (int v = 0; v < number.length; v++) {
                int at = 3 * number[v];
                for (int a = 0; a < 3 && at >= 0; a++) next[at + a] = grid.nextUnit(grid.cell(start[at + a], a), v, a);
            }
            int[] units = new PlaceChoice(equations, fitted, STAY_OF_PLACE, grid, next).choose();
            return moves(i -> grid.middleCell(units[i]) - grid.cell(start[i], i % 3));
        });
    }

    /** Moves of all vertices of the original from those of the coordinates in the levels. */
    private int[] moves(IntUnaryOperator move) {
        int[] moves = new int[3 * number.length];
        for (int i = 0; i < moves.length; i++)
            if (number[i / 3] >= 0) moves[i] = move.applyAsInt(3 * number[i / 3] + i % 3);
        return moves;
    }

    private void fitAll(List<int[]> levels) {
        number = new int[original.vertices()];
        Arrays.fill(number, -1);
        int vertices = 0;
        PointField[] fields = new PointField[levels.size()];
        int rows = 0;
        int fewest = Math.min(FEWEST_POINTS, 4 * original.vertices());
        List<int[]> numbered = new ArrayList<>();
        for (int i = 0; i < fields.length; i++) {
            int[] level = levels.get(fields.length - 1 - i).clone(); // coarsest first
            vertices = renumber(level, vertices);
            numbered.add(level);
            int points = Math.max(fewest, POINTS_PER_VERTEX * vertices);
            fields[i] = new PointField(surface.take(points, STREWN));
            rows += points;
        }
        start = new double[3 * vertices];
        for (int i = 0; i < 3 * number.length; i++) {
            if (number[i / 3] >= 0) start[3 * number[i / 3] + i % 3] = original.positions()[i];
        }
        fitted = start.clone();
        for (int round = 0; round < ROUNDS; round++) {
            equations = null; // two would not be needed at a time
            equations = new PointEquations(start, rows);
            for (int i = 0; i < fields.length; i++) addLevel(equations, numbered.get(i), fields[i]);
            equations.solve(fitted, STAY, STEPS);
        }
    }

    /**
     * About the mean distance of a level from the original, with its vertices moved.
     *
     * @param level three vertices of the original per triangle
     * @param moves of all vertices along x, y, z in units; null for none
     */
    public double error(int[] level, int[] moves, double unit) {
        return stages.during("fitting", () -> measured(level, moves, unit));
    }

    private double measured(int[] level, int[] moves, double unit) {
        float[] positions = original.positions().clone();
        if (moves != null)
            for (int v : level)
                for (int i = 3 * v; i < 3 * v + 3; i++)
                    positions[i] = finite(original.positions()[i] + unit * moves[i]);
        PointField field = new PointField(surface.take(POINTS_OF_ERROR, STREWN));
        measure(field, positions, level);
        double error = 0;
        for (double distance : field.distances()) error += distance;
        return error / POINTS_OF_ERROR;
    }

    private void measure(PointField field, float[] positions, int[] triangles) {
        field.isCrowded |= isCrowded;
        field.measure(positions, triangles, 1);
        isCrowded = field.isCrowded;
    }

    /** The float32 closest to a number; a fit may lead beyond the largest one. */
    private static float finite(double x) {
        return (float) Math.max(-Float.MAX_VALUE, Math.min(Float.MAX_VALUE, x));
    }

    /** Numbers the vertices in the order of the levels, and rewrites the levels with these numbers. */
    private int renumber(int[] triangles, int vertices) {
        int n = vertices;
        for (int i = 0; i < triangles.length; i++) {
            int v = triangles[i];
            if (number[v] < 0) number[v] = n++;
            triangles[i] = number[v];
        }
        return n;
    }

    private void addLevel(PointEquations equations, int[] triangles, PointField field) {
        float[] positions = new float[fitted.length];
        for (int i = 0; i < positions.length; i++) positions[i] = finite(fitted[i]);
        measure(field, positions, triangles);
        int n = field.size();
        double error = 0;
        for (double distance : field.distances()) error += distance / n;
        if (error == 0) return;
        double weight = StrictMath.pow(error, POWER_OF_ERROR) / n;
        double[] points = field.points();
        double[] point = new double[3];
        for (int i = 0; i < n; i++) {
            int at = field.nearest()[i];
            System.arraycopy(points, 3 * i, point, 0, 3);
            closest.find(positions, triangles, at, point[0], point[1], point[2]);
            equations.add(triangles, at, closest.shares, point, closest.direction, weight);
        }
    }
}
