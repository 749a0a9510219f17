package org.jsmesh.encode.measure;

import java.util.Arrays;

/**
 * Finds positions of vertices such that points of triangles between them come close to given points: linear least
 * squares, solved by conjugate gradients. Each distance counts fully along a direction, and little across it, because
 * there another point of the triangles takes over.
 */
final class PointEquations {
    /** Weight of a distance across its direction. */
    private static final double ACROSS = 0.1;

    private final double[] start;
    private final int[] vertices; // three per row
    private final double[] shares;
    private final double[] targets;
    private final double[] directions; // of length 1
    private final double[] weights;
    private final double[] pull = new double[3]; // of the last row
    private int rows;

    /** @param start x, y, z that each vertex should stay close to */
    PointEquations(double[] start, int capacity) {
        this.start = start;
        vertices = new int[3 * capacity];
        shares = new double[3 * capacity];
        targets = new double[3 * capacity];
        directions = new double[3 * capacity];
        weights = new double[capacity];
    }

    /** Adds a point that a weighted mean of the vertices {@code list[at .. at + 2]} should come to, in a direction. */
    void add(int[] list, int at, double[] share, double[] point, double[] direction, double weight) {
        System.arraycopy(list, at, vertices, 3 * rows, 3);
        System.arraycopy(share, 0, shares, 3 * rows, 3);
        System.arraycopy(point, 0, targets, 3 * rows, 3);
        System.arraycopy(direction, 0, directions, 3 * rows, 3);
        weights[rows++] = weight;
    }

    /**
     * Improves positions.
     *
     * @param stay weight of a vertex's start, in parts of the mean weight of a vertex's points
     */
    void solve(double[] x, double stay, int steps) {
        int n = x.length;
        double own = weightOfStart(n, stay);
        double[] diagonal = new double[n];
        Arrays.fill(diagonal, own);
        double[] rest = new double[n];
        for (int i = 0; i < n; i++) rest[i] = own * start[i];
        for (int i = 0; i < 3 * rows; i += 3) {
            pull(i, targets[i], targets[i + 1], targets[i + 2]);
            for (int a = 0; a < 3; a++) {
                double along = directions[i + a];
                double square = weights[i / 3] * (ACROSS + (1 - ACROSS) * along * along);
                for (int j = i; j < i + 3; j++) {
                    diagonal[3 * vertices[j] + a] += square * shares[j] * shares[j];
                    rest[3 * vertices[j] + a] += shares[j] * pull[a];
                }
            }
        }
        double[] product = multiply(x, own);
        double[] direction = new double[n];
        double size = 0;
        for (int i = 0; i < n; i++) {
            rest[i] -= product[i];
            direction[i] = rest[i] / diagonal[i];
            size += rest[i] * direction[i];
        }
        for (int k = 0; k < steps && size > 0; k++) {
            product = multiply(direction, own);
            double across = 0;
            for (int i = 0; i < n; i++) across += direction[i] * product[i];
            double step = size / across;
            double next = 0;
            for (int i = 0; i < n; i++) {
                x[i] += step * direction[i];
                rest[i] -= step * product[i];
                next += rest[i] * rest[i] / diagonal[i];
            }
            for (int i = 0; i < n; i++) direction[i] = rest[i] / diagonal[i] + next / size * direction[i];
            size = next;
        }
    }

    /** The weight of a vertex's start, which is given in parts of the mean weight of a vertex's points. */
    double weightOfStart(int coordinates, double stay) {
        double own = 0;
        for (int i = 0; i < rows; i++) own += weights[i];
        return own * (stay / (coordinates / 3.0));
    }

    /** Corners of all rows. */
    int corners() {
        return 3 * rows;
    }

    /** The vertex at a corner: three times the row, plus 0, 1 or 2. */
    int vertex(int corner) {
        return vertices[corner];
    }

    /** Half the sum of the squares at x, without those of the starts. */
    double square(double[] x) {
        double sum = 0;
        for (int i = 0; i < 3 * rows; i += 3) {
            double dx = mean(x, i, 0) - targets[i];
            double dy = mean(x, i, 1) - targets[i + 1];
            double dz = mean(x, i, 2) - targets[i + 2];
            pull(i, dx, dy, dz);
            sum += pull[0] * dx + pull[1] * dy + pull[2] * dz;
        }
        return sum / 2;
    }

    /**
     * The first derivatives of half the sum of the squares at x.
     *
     * @param own weight of a vertex's start
     */
    double[] slope(double[] x, double own) {
        double[] slope = multiply(x, own);
        for (int i = 0; i < slope.length; i++) slope[i] -= own * start[i];
        for (int i = 0; i < 3 * rows; i += 3) {
            pull(i, targets[i], targets[i + 1], targets[i + 2]);
            for (int j = i; j < i + 3; j++)
                for (int a = 0; a < 3; a++) slope[3 * vertices[j] + a] -= shares[j] * pull[a];
        }
        return slope;
    }

    /** Adds to the first derivatives what they change by one row when the vertex at a corner of it moves. */
    void addSlope(double[] slope, int corner, double[] step) {
        int i = corner - corner % 3;
        double share = shares[corner];
        pull(i, share * step[0], share * step[1], share * step[2]);
        for (int j = i; j < i + 3; j++) for (int a = 0; a < 3; a++) slope[3 * vertices[j] + a] += shares[j] * pull[a];
    }

    /**
     * The second derivatives by the coordinates of each vertex alone: xx, xy, xz, yy, yz, zz.
     *
     * @param own weight of a vertex's start
     */
    double[] blocks(int count, double own) {
        double[] blocks = new double[6 * count];
        for (int at = 0; at < blocks.length; at += 6) blocks[at] = blocks[at + 3] = blocks[at + 5] = own;
        for (int i = 0; i < 3 * rows; i++) {
            int d = i - i % 3;
            double square = weights[i / 3] * shares[i] * shares[i];
            double along = (1 - ACROSS) * square;
            int at = 6 * vertices[i];
            for (int a = 0; a < 3; a++)
                for (int b = a; b < 3; b++, at++)
                    blocks[at] += along * directions[d + a] * directions[d + b] + (a == b ? ACROSS * square : 0);
        }
        return blocks;
    }

    private double[] multiply(double[] x, double own) {
        double[] product = new double[x.length];
        for (int i = 0; i < product.length; i++) product[i] = own * x[i];
        for (int i = 0; i < 3 * rows; i += 3) {
            pull(i, mean(x, i, 0), mean(x, i, 1), mean(x, i, 2));
            for (int j = i; j < i + 3; j++)
                for (int a = 0; a < 3; a++) product[3 * vertices[j] + a] += shares[j] * pull[a];
        }
        return product;
    }

    private double mean(double[] x, int row, int axis) {
        double sum = 0;
        for (int j = row; j < row + 3; j++) sum += shares[j] * x[3 * vertices[j] + axis];
        return sum;
    }

    /** What a row, given by three times its number, makes of a vector. */
    private void pull(int row, double x, double y, double z) {
        double w = weights[row / 3];
        double dx = directions[row];
        double dy = directions[row + 1];
        double dz = directions[row + 2];
        double along = (1 - ACROSS) * (x * dx + y * dy + z * dz);
        pull[0] = w * (ACROSS * x + along * dx);
        pull[1] = w * (ACROSS * y + along * dy);
        pull[2] = w * (ACROSS * z + along * dz);
    }
}
