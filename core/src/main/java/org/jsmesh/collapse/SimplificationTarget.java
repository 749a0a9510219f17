package org.jsmesh.collapse;

/**
 * Where a simplification stops: as soon as the mesh has no more than so many faces or no more than so many vertices, or
 * when nothing can be removed.
 *
 * @param faces 0 for no such limit
 * @param vertices 0 for no such limit; each fan of a cut vertex counts
 */
public record SimplificationTarget(int faces, int vertices) {
    public SimplificationTarget {
        if (faces < 0 || vertices < 0)
            throw new IllegalArgumentException("target of " + faces + " faces, " + vertices + " vertices");
    }

    /** Stops at a number of faces. */
    public static SimplificationTarget ofFaces(int faces) {
        return new SimplificationTarget(faces, 0);
    }

    /** Stops at a number of vertices. */
    public static SimplificationTarget ofVertices(int vertices) {
        return new SimplificationTarget(0, vertices);
    }

    /** Stops when nothing can be removed. */
    public static SimplificationTarget floor() {
        return new SimplificationTarget(0, 0);
    }

    boolean isReached(int facesNow, int verticesNow) {
        return facesNow <= faces || verticesNow <= vertices;
    }
}
