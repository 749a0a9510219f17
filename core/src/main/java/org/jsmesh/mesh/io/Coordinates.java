package org.jsmesh.mesh.io;

import java.util.Arrays;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;
import org.jsmesh.mesh.Sizes;

/**
 * The coordinates of vertices as a reader collects them: float32 where that holds all of them, else double precision. A
 * decimal is held when float32 gives back its text ({@link Decimal#isHeldByFloat}). In a file with a decimal that is
 * not held, all are taken as the closest doubles.
 */
final class Coordinates {
    private double[] values;
    private int size;
    private boolean isDouble;
    private Mesh points; // when all are there

    /** @param expected number of coordinates */
    Coordinates(int expected) {
        values = new double[Math.max(16, expected)];
    }

    /** Adds a decimal. */
    void add(Decimal decimal) {
        grow();
        set(size, decimal);
    }

    /** Adds a coordinate that the file does not have. */
    void addZero() {
        grow();
        values[size++] = 0;
    }

    private void grow() {
        if (size == values.length) values = Arrays.copyOf(values, Sizes.more(size, "coordinates of vertices"));
    }

    /** Those of all but some vertices, which come in their order. */
    Coordinates without(int[] vertices) {
        Coordinates left = new Coordinates(size - 3 * vertices.length);
        left.isDouble = isDouble;
        int from = 0;
        for (int i = 0; i <= vertices.length; i++) {
            int end = i < vertices.length ? 3 * vertices[i] : size;
            System.arraycopy(values, from, left.values, left.size, end - from);
            left.size += end - from;
            from = end + 3;
        }
        return left;
    }

    /** Sets a coordinate by its place, to a decimal. */
    void set(int index, Decimal decimal) {
        values[index] = decimal.toDouble();
        size = Math.max(size, index + 1);
        if (!isDouble) isDouble = !decimal.isHeldByFloat();
    }

    /** Sets a coordinate by its place, to a number of a binary file or of one that declares float64. */
    void set(int index, double number) {
        values[index] = number;
        size = Math.max(size, index + 1);
        if (!isDouble) isDouble = (float) number != number && number == number;
    }

    /** The number of coordinates, three for each vertex. */
    int size() {
        return size;
    }

    private Mesh points() {
        if (points != null) return points;
        MeshBuilder builder = new MeshBuilder();
        if (isDouble) {
            builder.positions(Arrays.copyOf(values, size));
        } else {
            float[] floats = new float[size];
            for (int i = 0; i < size; i++) floats[i] = (float) values[i];
            builder.positions(floats);
        }
        values = new double[0];
        points = builder.build();
        return points;
    }

    /** x, y, z of each vertex to compute with: offsets from an origin in double precision. */
    float[] offsets() {
        return points().positions();
    }

    /** Starts a mesh of these vertices. */
    MeshAssembler assembler(int[] cornerVertices, int[] faceCorners) {
        Mesh all = points();
        if (all.exactPositions() != null) return new MeshAssembler(all.exactPositions(), cornerVertices, faceCorners);
        return new MeshAssembler(all.positions(), cornerVertices, faceCorners);
    }
}
