package org.jsmesh.display;

import java.util.Arrays;
import java.util.BitSet;
import org.jsmesh.mesh.GrowingMesh;

/** The positions of vertices now, and before the step. */
final class LivePositions {
    private final GrowingMesh mesh;
    private float[] now = new float[0];
    private float[] before = new float[0]; // of the vertices that a step concerns
    private int known; // vertices before the step

    LivePositions(GrowingMesh mesh) {
        this.mesh = mesh;
    }

    /**
     * Takes over the positions of the vertices that a step concerns, and keeps those before: a new vertex was where its
     * parent was. Parents come before their children, and are among the changed vertices.
     */
    void update(BitSet changed) {
        int vertices = mesh.vertices();
        if (3 * vertices > now.length) {
            int room = 3 * (vertices + vertices / 2);
            now = Arrays.copyOf(now, room);
            before = Arrays.copyOf(before, room);
        }
        for (int v = changed.nextSetBit(0); v >= 0; v = changed.nextSetBit(v + 1)) update(v);
        known = vertices;
    }

    private void update(int v) {
        int parent = v < known ? v : known == 0 ? -1 : mesh.parent(v);
        float[] from = v < known ? now : before;
        for (int a = 0; a < 3; a++) {
            float coordinate = mesh.coordinate(v, a);
            before[3 * v + a] = parent < 0 ? coordinate : from[3 * parent + a];
            now[3 * v + a] = coordinate;
        }
    }

    /** Three numbers per vertex; replaced when there are more. */
    float[] now() {
        return now;
    }

    /** Three numbers per vertex that the step concerns. */
    float[] before() {
        return before;
    }

    /** Has a vertex moved that the step concerns? */
    boolean isMoved(int vertex) {
        int at = 3 * vertex;
        return now[at] != before[at] || now[at + 1] != before[at + 1] || now[at + 2] != before[at + 2];
    }
}
