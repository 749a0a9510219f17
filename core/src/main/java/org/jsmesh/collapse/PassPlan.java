package org.jsmesh.collapse;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/**
 * Distributes collapses that were made one after the other over passes. The stars of the vertices removed in one pass
 * share no face, and the mesh after the last pass is the same.
 *
 * <p>Every collapse goes to the first pass after those that changed a face of its star. Collapses that change the
 * number of faces about a vertex stay in order, so that this number and with it the link condition hold in every mesh
 * between. Levels begin with a new pass.
 */
final class PassPlan {
    /**
     * Most faces that a vertex may gain while a pass is undone, losses not counted. The decoder undoes a pass in its
     * own order. In between, a vertex has at most so many faces above the most that {@link TopologyTest} allows; the
     * codec can take that many.
     */
    private static final int MOST_GAINS = 4;

    private final CollapseMesh mesh;
    private final int[] facePass; // last pass that changed a face, from 1
    private final int[] vertexPass; // last pass that changed the number of faces about a vertex
    private final int[] gains; // by how many faces undoing that pass makes the vertex grow
    private int[] passOf = new int[256];
    private int[] levelOf = new int[16]; // of each pass
    private int passes;
    private int level;
    private int levelStart;
    private int patches;

    PassPlan(CollapseMesh mesh) {
        this.mesh = mesh;
        facePass = new int[mesh.table().faces()];
        vertexPass = new int[mesh.table().vertices()];
        gains = new int[mesh.table().vertices()];
    }

    /** Begins a level: the passes of the collapses that follow come after those so far. */
    void beginLevel(int number) {
        level = number;
        levelStart = passes;
    }

    /** Takes in the collapse of the star's vertex to its neighbour i, which is about to be made. */
    void add(VertexStar star, int i) {
        int n = star.size;
        int left = star.neighbour[i + 1 == n ? 0 : i + 1];
        int right = star.neighbour[i == 0 ? n - 1 : i - 1];
        int kept = star.neighbour[i];
        int keptGain = n == 3 ? 1 : 0; // its run of one face comes back as two
        int pass = levelStart + 1;
        for (int j = 0; j < n; j++) pass = Math.max(pass, facePass[CornerTable.face(star.corner[j])] + 1);
        pass = Math.max(pass, first(kept, keptGain));
        pass = Math.max(pass, Math.max(first(left, 1), first(right, 1)));
        for (int j = 0; j < n; j++) facePass[CornerTable.face(star.corner[j])] = pass;
        gain(kept, pass, keptGain);
        gain(left, pass, 1);
        gain(right, pass, 1);
        if (pass > passes) {
            if (passes == levelOf.length) levelOf = Arrays.copyOf(levelOf, 2 * passes);
            levelOf[passes++] = level;
        }
        if (patches == passOf.length) passOf = Arrays.copyOf(passOf, 2 * patches);
        passOf[patches++] = pass - 1;
    }

    /** First pass in which a vertex can gain or lose so many faces. */
    private int first(int vertex, int gain) {
        if (vertex == CornerTable.OUTSIDE) return 0;
        return vertexPass[vertex] + (gains[vertex] + gain > MOST_GAINS ? 1 : 0);
    }

    private void gain(int vertex, int pass, int gain) {
        if (vertex == CornerTable.OUTSIDE) return;
        if (vertexPass[vertex] < pass) gains[vertex] = 0;
        vertexPass[vertex] = pass;
        gains[vertex] += gain;
    }

    /** Brings the log of the mesh into the order of the passes. */
    void arrange() {
        mesh.log().arrange(passOf, Arrays.copyOf(levelOf, passes));
    }
}
