package org.jsmesh.encode;

import java.util.Arrays;
import java.util.Random;
import java.util.function.IntFunction;
import org.jsmesh.mesh.Mesh;

/** Meshes that have as much of something as their faces allow, for any number of faces. */
enum ExtremeMesh {
    FACES_OF_ONE_EDGE(StrangeMesh::book),
    FACES_OF_ONE_VERTEX(StrangeMesh::bunch),
    ONE_FACE_MANY_TIMES(StrangeMesh::repeated),
    OPEN_FAN(n -> StrangeMesh.fan(n, false)),
    CLOSED_FAN(n -> StrangeMesh.fan(n, true)),
    CONE_OF_DEGENERATE_FACES(StrangeMesh::degenerate),
    STRIP(StrangeMesh::strip),
    SEPARATE_FACES(StrangeMesh::triangles),
    SEPARATE_TETRAHEDRA(n -> StrangeMesh.tetrahedra(n / 4)),
    FACES_BETWEEN_ANY_VERTICES(n -> any(n, n / 2, 3)),
    FACES_BETWEEN_ANY_VERTICES_OF_A_PLANE(n -> any(n, n / 2, 2)),
    FACES_BETWEEN_ANY_VERTICES_OF_A_LINE(n -> any(n, n / 2, 1)),
    FACES_BETWEEN_FEW_VERTICES(n -> any(n, 12, 3)),
    LARGE_FACES_IN_A_ROW(n -> across(n, false)),
    LARGE_FACES_AT_ONE_PLACE(n -> across(n, true)),
    EDGES_OF_THREE_FACES(ExtremeMesh::sheets);

    private final IntFunction<Mesh> maker;

    ExtremeMesh(IntFunction<Mesh> maker) {
        this.maker = maker;
    }

    Mesh of(int faces) {
        return maker.apply(faces);
    }

    private static Mesh any(int n, int vertices, int axes) {
        Random random = new Random(n);
        float[] p = new float[3 * vertices];
        for (int i = 0; i < p.length; i++) p[i] = i % 3 < axes ? random.nextFloat() : 0;
        return StrangeMesh.mesh(p, random.ints(3L * n, 0, vertices).toArray());
    }

    /** Strips as wide as they are long, or folded up. */
    private static Mesh across(int n, boolean folded) {
        Mesh strip = StrangeMesh.strip(n);
        float[] p = strip.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            p[i + 1] *= n;
            if (folded) p[i] %= 2;
        }
        return StrangeMesh.mesh(p, strip.faceWedges());
    }

    /** A grid of which each edge has a further face. */
    private static Mesh sheets(int n) {
        int side = (int) Math.sqrt(n / 4.0) + 1;
        Mesh grid = StrangeMesh.grid(side, 1, 0);
        int[] corners = grid.faceWedges();
        int[] faces = Arrays.copyOf(corners, 2 * corners.length);
        for (int i = 0; i < corners.length; i++) {
            boolean isTip = i % 3 == 2;
            faces[corners.length + i] = isTip ? (corners[i] + 3 * side + 1) % (side * side) : corners[i];
        }
        return StrangeMesh.mesh(grid.positions(), faces);
    }
}
