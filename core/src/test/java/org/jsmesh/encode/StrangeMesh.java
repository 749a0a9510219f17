package org.jsmesh.encode;

import java.util.Arrays;
import java.util.function.Supplier;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshBuilder;

/** Meshes at the limits of what a mesh is. */
enum StrangeMesh {
    ONE_TRIANGLE(() -> triangles(1)),
    TWO_TRIANGLES(() -> triangles(2)),
    TWO_TRIANGLES_WITH_AN_EDGE(() -> strip(2)),
    TETRAHEDRON(() -> tetrahedra(1)),
    ONE_FACE_OF_TWO_VERTICES(() -> mesh(new float[] {0, 0, 0, 1, 0, 0}, new int[] {0, 1, 1})),
    ONE_FACE_OF_ONE_VERTEX(() -> mesh(new float[] {1, 2, 3}, new int[3])),
    ALL_FACES_DEGENERATE(() -> degenerate(100)),
    ONE_FACE_A_THOUSAND_TIMES(() -> repeated(1000)),
    ALL_ON_A_LINE(() -> flattened(1)),
    ALL_AT_ONE_POINT(() -> flattened(0)),
    NEGATIVE_ZEROS(() -> with(grid(20, 1, 0), -0f, 0f, -0f)),
    ONE_ENORMOUS_NUMBER(() -> with(grid(20, 1, 0), 1e38f)),
    ENORMOUS_NUMBERS(() -> grid(20, 1.5e37, 0)),
    LARGEST_NUMBERS(() -> with(grid(20, 1.5e37, 0), Float.MAX_VALUE, -Float.MAX_VALUE)),
    ENORMOUS_OFFSET(() -> grid(20, 1e36, 1e38)),
    DENORMAL_NUMBERS(() -> grid(20, 1e-41, 0)),
    LEAST_NUMBERS(() -> grid(20, Float.MIN_VALUE, 0)),
    ONE_DENORMAL_NUMBER(() -> with(grid(20, 1, 0), Float.MIN_VALUE)),
    ONE_LARGE_NUMBER_BESIDE_DECIMALS(
            () -> mesh(new float[] {-.85f, .52f, 0, -.85f, -.52f, 1 << 24, -.95f, 0, .85f}, new int[] {0, 1, 2})),
    FAR_NUMBERS_BESIDE_DECIMALS(() -> mesh(
            new float[] {
                .525731027f,
                1.62259277e32f,
                4.46466067e30f,
                .850651026f,
                -.525731027f,
                0,
                .850651026f,
                .525731027f,
                0,
                .525731027f,
                0,
                -.850651026f,
                0,
                -.525731027f,
                -.850651026f
            },
            new int[] {0, 1, 2, 3, 1, 4})),
    FAN_OF_10000(() -> fan(10_000, false)),
    CLOSED_FAN_OF_10000(() -> fan(10_000, true)),
    EDGE_OF_3000_FACES(() -> book(3000)),
    VERTEX_OF_3000_FANS(() -> bunch(3000)),
    LONG_STRIP(() -> strip(20_000)),
    SEPARATE_TRIANGLES(() -> triangles(100_000)),
    SEPARATE_TETRAHEDRA(() -> tetrahedra(20_000));

    private final Supplier<Mesh> maker;

    StrangeMesh(Supplier<Mesh> maker) {
        this.maker = maker;
    }

    Mesh mesh() {
        return maker.get();
    }

    /** A height field of n × n vertices. */
    static Mesh grid(int n, double scale, double offset) {
        float[] p = new float[3 * n * n];
        int[] faces = new int[6 * (n - 1) * (n - 1)];
        int at = 0;
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < n; x++) {
                int v = y * n + x;
                p[3 * v] = (float) ((x - n / 2.0) * scale + offset);
                p[3 * v + 1] = (float) ((y - n / 2.0) * scale);
                p[3 * v + 2] = (float) (Math.sin(0.3 * x) * Math.cos(0.2 * y) * scale);
                if (x + 1 == n || y + 1 == n) continue;
                for (int w : new int[] {v, v + 1, v + n + 1, v, v + n + 1, v + n}) faces[at++] = w;
            }
        }
        return mesh(p, faces);
    }

    static Mesh mesh(float[] positions, int[] faces) {
        return new MeshBuilder().positions(positions).faceWedges(faces).build();
    }

    private static Mesh with(Mesh mesh, float... values) {
        float[] p = mesh.positions().clone();
        System.arraycopy(values, 0, p, 100, values.length);
        return mesh(p, mesh.faceWedges());
    }

    /** A grid with all but the first so many coordinates the same. */
    private static Mesh flattened(int axes) {
        Mesh grid = grid(20, 1, 0);
        float[] p = grid.positions().clone();
        for (int i = 0; i < p.length; i++) if (i % 3 >= axes) p[i] = 2.5f;
        return mesh(p, grid.faceWedges());
    }

    static Mesh triangles(int n) {
        float[] p = new float[9 * n];
        for (int i = 0; i < 3 * n; i++) {
            p[3 * i] = i / 3 % 1000 + (i % 3 == 1 ? 0.7f : 0);
            p[3 * i + 1] = i / 3000 + (i % 3 == 2 ? 0.7f : 0);
            p[3 * i + 2] = (float) Math.sin(0.01 * (i / 3));
        }
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i);
        return mesh(p, faces);
    }

    static Mesh tetrahedra(int n) {
        float[] p = new float[12 * n];
        for (int i = 0; i < 4 * n; i++) {
            p[3 * i] = i / 4 % 150 + (i % 4 == 1 ? 0.5f : 0);
            p[3 * i + 1] = i / 600 + (i % 4 == 2 ? 0.5f : 0);
            p[3 * i + 2] = (float) Math.sin(0.1 * (i / 4)) + (i % 4 == 3 ? 0.5f : 0);
        }
        int[] one = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
        int[] faces = new int[12 * n];
        Arrays.setAll(faces, i -> 4 * (i / 12) + one[i % 12]);
        return mesh(p, faces);
    }

    /** Faces with two equal corners. */
    static Mesh degenerate(int n) {
        float[] p = new float[3 * n + 3];
        for (int i = 0; i < p.length; i++) p[i] = i * i % 17;
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i / 3 + (i % 3 == 2 ? 1 : 0));
        return mesh(p, faces);
    }

    static Mesh repeated(int n) {
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i % 3);
        return mesh(new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, faces);
    }

    /** Faces about vertex 0. */
    static Mesh fan(int n, boolean closed) {
        int ring = closed ? n : n + 1;
        float[] p = ring(1, ring);
        p[2] = 0.3f;
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i % 3 == 0 ? 0 : 1 + (i / 3 + i % 3 - 1) % ring);
        return mesh(p, faces);
    }

    /** Faces with one edge in common. */
    static Mesh book(int n) {
        float[] p = ring(2, n);
        p[5] = 1;
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i % 3 < 2 ? i % 3 : 2 + i / 3);
        return mesh(p, faces);
    }

    /** Faces with nothing but one vertex in common. */
    static Mesh bunch(int n) {
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i % 3 == 0 ? 0 : 2 * (i / 3) + i % 3);
        return mesh(ring(1, 2 * n), faces);
    }

    /** Vertices on a circle after some at its centre. */
    private static float[] ring(int before, int n) {
        float[] p = new float[3 * (before + n)];
        for (int i = 0; i < n; i++) {
            p[3 * (before + i)] = (float) Math.cos(2 * Math.PI * i / n);
            p[3 * (before + i) + 1] = (float) Math.sin(2 * Math.PI * i / n);
        }
        return p;
    }

    static Mesh strip(int n) {
        float[] p = new float[3 * (n + 2)];
        for (int i = 0; i < n + 2; i++) {
            p[3 * i] = i / 2;
            p[3 * i + 1] = i % 2;
            p[3 * i + 2] = (float) Math.sin(0.05 * i);
        }
        int[] faces = new int[3 * n];
        Arrays.setAll(faces, i -> i / 3 + (i % 3 == 0 || i / 3 % 2 == 0 ? i % 3 : 3 - i % 3));
        return mesh(p, faces);
    }
}
