package org.jsmesh.encode.measure;

import java.util.Arrays;

/**
 * Finds positions of vertices such that points of triangles between them come close to given points: linear least
 * squares, solved by conjugate gradients.
 */
final class PointEquations {
    private final double[] start;
    private final int[] vertices; // three per row
    private final double[] shares;
    private final double[] targets;
    private final double[] weights;
    private int rows;

    /** @param start x, y, z that each vertex should stay close to */
    PointEquations(double[] start, int capacity) {
        this.start = start;
        vertices = new int[3 * capacity];
        shares = new double[3 * capacity];
        targets = new double[3 * capacity];
        weights = new double[capacity];
    }

    /** Adds a point that a weighted mean of the vertices {@code list[at .. at + 2]} should come to. */
    void add(int[] list, int at, double[] share, double x, double y, double z, double weight) {
        System.arraycopy(list, at, vertices, 3 * rows, 3);
        System.arraycopy(share, 0, shares, 3 * rows, 3);
        targets[3 * rows] = x;
        targets[3 * rows + 1] = y;
        targets[3 * rows + 2] = z;
        weights[rows++] = weight;
    }

    /**
     * Improves positions.
     *
     * @param stay weight of a vertex's start, in parts of the mean weight of a vertex's points
     */
    void solve(double[] x, double stay, int steps) {
        int n = x.length;
        double own = 0;
        for (int i = 0; i < rows; i++) own += weights[i];
        double[] diagonal = new double[n / 3];
        own *= stay / diagonal.length;
        Arrays.fill(diagonal, own);
        double[] rest = new double[n];
        for (int i = 0; i < n; i++) rest[i] = own * start[i];
        for (int i = 0; i < 3 * rows; i++) {
            double w = weights[i / 3] * shares[i];
            diagonal[vertices[i]] += w * shares[i];
            for (int a = 0; a < 3; a++) rest[3 * vertices[i] + a] += w * targets[i / 3 * 3 + a];
        }
        double[] product = multiply(x, own);
        double[] direction = new double[n];
        double size = 0;
        for (int i = 0; i < n; i++) {
            rest[i] -= product[i];
            direction[i] = rest[i] / diagonal[i / 3];
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
                next += rest[i] * rest[i] / diagonal[i / 3];
            }
            for (int i = 0; i < n; i++) direction[i] = rest[i] / diagonal[i / 3] + next / size * direction[i];
            size = next;
        }
    }

    private double[] multiply(double[] x, double own) {
        double[] product = new double[x.length];
        for (int i = 0; i < product.length; i++) product[i] = own * x[i];
        for (int i = 0; i < 3 * rows; i += 3) {
            for (int a = 0; a < 3; a++) {
                double sum = 0;
                for (int j = i; j < i + 3; j++) sum += shares[j] * x[3 * vertices[j] + a];
                sum *= weights[i / 3];
                for (int j = i; j < i + 3; j++) product[3 * vertices[j] + a] += sum * shares[j];
            }
        }
        return product;
    }
}
