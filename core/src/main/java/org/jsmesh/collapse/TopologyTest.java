package org.jsmesh.collapse;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;

/**
 * Tells whether a half-edge collapse keeps the mesh a manifold of the same topology, and keeps the regions between
 * features.
 *
 * <p>The link condition (Dey, Edelsbrunner, Guha, Nekhayev 1999): the common neighbours of both ends are exactly the
 * apexes of the two removed faces. {@link CornerTable#OUTSIDE} counts as a neighbour, which covers boundaries. Not
 * thread-safe.
 */
final class TopologyTest {
    private static final int LEAST_VALENCE = 3;
    /**
     * A coder splits no vertex of more than 64 faces, and splits around a vertex may give it half as many again before
     * its turn comes.
     */
    private static final int LARGEST_VALENCE = 40;

    private final CollapseMesh mesh;
    private final int[] marks; // by vertex + 1
    private int mark;

    TopologyTest(CollapseMesh mesh) {
        this.mesh = mesh;
        marks = new int[mesh.table().vertices() + 1];
    }

    /** Makes u the vertex to be removed in the following tests. */
    void setRemoved(VertexStar star) {
        if (++mark == Integer.MAX_VALUE) {
            Arrays.fill(marks, 0);
            mark = 1;
        }
        for (int i = 0; i < star.size; i++) marks[star.neighbour[i] + 1] = mark;
    }

    /** May the vertex of the star go to its neighbour i? */
    boolean isCollapsible(VertexStar star, int i) {
        int n = star.size;
        int left = star.neighbour[i + 1 == n ? 0 : i + 1];
        int right = star.neighbour[i == 0 ? n - 1 : i - 1];
        return star.neighbour[i] != CornerTable.OUTSIDE && isLinkKept(star, i) && keepsFeatures(star, i, left, right);
    }

    /**
     * This also keeps three faces around either apex. If an apex had only three, its third neighbour would be a common
     * neighbour too.
     */
    private boolean isLinkKept(VertexStar star, int i) {
        int[] data = mesh.table().data();
        int start = CornerTable.next(star.corner[i]);
        int valence = 0;
        int common = 0;
        int c = start;
        do {
            if (marks[data[CornerTable.next(c)] + 1] == mark) common++;
            if (++valence > LARGEST_VALENCE + 1) return false;
            c = data[c + 4];
        } while (c != start);
        int after = valence + star.size - 4;
        return common == 2 && valence >= LEAST_VALENCE && after >= LEAST_VALENCE && after <= LARGEST_VALENCE;
    }

    /**
     * Is no removed face the last of a region between features? A region is one of a material, or of a chart of a
     * texture.
     */
    private boolean keepsFeatures(VertexStar star, int i, int left, int right) {
        CornerTable t = mesh.table();
        int n = star.size;
        int h = star.corner[i];
        int r = star.corner[i == 0 ? n - 1 : i - 1];
        return (left == CornerTable.OUTSIDE
                        || keepsRegion(
                                h, star.sharp[i + 1 == n ? 0 : i + 1], t.swing(h), t.swingBack(CornerTable.next(h))))
                && (right == CornerTable.OUTSIDE
                        || keepsRegion(r, star.sharp[i == 0 ? n - 1 : i - 1], t.swingBack(r), CornerTable.previous(r)));
    }

    /**
     * @param corner of u in the removed face
     * @param sharp is its edge u-x?
     * @param inRun a corner of the face behind u-x
     * @param besides corner of v whose swing, or which itself, crosses v-x
     */
    private boolean keepsRegion(int corner, boolean sharp, int inRun, int besides) {
        if (!sharp || !mesh.isSharp(besides)) return true;
        if (mesh.hasTexture()) return false;
        int face = CornerTable.face(corner);
        int beside = CornerTable.face(besides) == face
                ? CornerTable.face(mesh.table().swing(besides))
                : CornerTable.face(besides);
        return mesh.isSameMaterial(face, CornerTable.face(inRun)) || mesh.isSameMaterial(face, beside);
    }
}
