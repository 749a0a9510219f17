package org.jsmesh.encode;

import java.util.Arrays;
import java.util.List;
import org.jsmesh.archive.CoarseFit;
import org.jsmesh.mesh.Mesh;

/**
 * Moves the vertices of coarse levels so that points of the original come close to all of their surfaces, in the sense of least squares; as Hoppe et al. 1993, 'Mesh optimization', do it for one mesh.
 * Deterministic.
 */
final class SurfaceFit implements CoarseFit.Fitter {
    private static final int ROUNDS = 2;

    /** Of conjugate gradients. */
    private static final int STEPS = 24;

    private static final int POINTS_PER_VERTEX = 6;
    /** Unless the original has few vertices. */
    private static final int FEWEST_POINTS = 6000;

    /** Weight of where a vertex belongs, in parts of that of its points. */
    private static final double STAY = 0.05;

    /** A level counts with this power of its error: with 2 all would be improved by the same share, if points alone counted; less favours coarse levels less. */
    private static final double POWER_OF_ERROR = -1.5;

    private final Mesh original;
    private final TriangleTree tree;
    private double[] start; // of the vertices of all levels
    private double[] fitted;
    private final ClosestPoint closest = new ClosestPoint();

    /** @param tree of the original's faces */
    SurfaceFit(Mesh original, TriangleTree tree) {
        this.original = original;
        this.tree = tree;
    }

    @Override
    public int[] fit(List<int[]> levels, double unit) {
        int[] number = new int[original.vertices()];
        Arrays.fill(number, -1);
        int vertices = 0;
        double[][] points = new double[levels.size()][];
        int rows = 0;
        int fewest = Math.min(FEWEST_POINTS, 4 * original.vertices());
        for (int i = 0; i < points.length; i++) {
            vertices = renumber(levels.get(i), number, vertices);
            points[i] = new SurfaceSamples(tree, Math.max(fewest, POINTS_PER_VERTEX * vertices)).points();
            rows += points[i].length / 3;
        }
        start = new double[3 * vertices];
        for (int i = 0; i < 3 * number.length; i++) {
            if (number[i / 3] >= 0) start[3 * number[i / 3] + i % 3] = original.positions()[i];
        }
        fitted = start.clone();
        for (int round = 0; round < ROUNDS; round++) {
            PointEquations equations = new PointEquations(start, rows);
            for (int i = 0; i < points.length; i++) addLevel(equations, levels.get(i), points[i]);
            equations.solve(fitted, STAY, STEPS);
        }
        int[] moves = new int[3 * number.length];
        for (int i = 0; i < moves.length; i++) {
            int at = 3 * number[i / 3] + i % 3;
            if (at >= 0) moves[i] = (int) Math.rint((fitted[at] - start[at]) / unit);
        }
        return moves;
    }

    /** Gives vertices numbers in the order of the levels, which then have those. */
    private static int renumber(int[] triangles, int[] number, int vertices) {
        int n = vertices;
        for (int i = 0; i < triangles.length; i++) {
            int v = triangles[i];
            if (number[v] < 0) number[v] = n++;
            triangles[i] = number[v];
        }
        return n;
    }

    private void addLevel(PointEquations equations, int[] triangles, double[] points) {
        float[] positions = new float[fitted.length];
        for (int i = 0; i < positions.length; i++) positions[i] = (float) fitted[i];
        TriangleTree level = new TriangleTree(positions, triangles, triangles.length / 3);
        TriangleTree.Cursor cursor = new TriangleTree.Cursor(level);
        int n = points.length / 3;
        int[] nearest = new int[n];
        double error = 0;
        for (int i = 0; i < n; i++) {
            error += Math.sqrt(cursor.squaredDistance(points[3 * i], points[3 * i + 1], points[3 * i + 2])) / n;
            nearest[i] = cursor.nearest();
        }
        if (error == 0) return;
        double weight = StrictMath.pow(error, POWER_OF_ERROR) / n;
        for (int i = 0; i < n; i++) {
            double x = points[3 * i];
            double y = points[3 * i + 1];
            double z = points[3 * i + 2];
            closest.find(level.corners(), 9 * nearest[i], x, y, z);
            equations.add(triangles, 3 * level.face(nearest[i]), closest.shares, x, y, z, weight);
        }
    }
}
