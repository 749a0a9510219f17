package org.jsmesh.collapse;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/**
 * Undoes the patches of a log on plain lists of faces, with nothing of the corner table but its faces at the end: slow
 * and simple. It reads of the original only the wedges that a decoder would have to be told, and fails when a wedge of
 * a removed face is neither new nor found beside the face.
 */
final class ReferenceUndo {
    private final CollapseMesh mesh;
    private final PatchLog log;
    private final int[][] vertices; // of each face, dummies included; null when removed
    private final int[][] wedges;
    private final List<Set<Integer>> facesAbout = new ArrayList<>();

    ReferenceUndo(CollapseMesh mesh) {
        this.mesh = mesh;
        log = mesh.log();
        CornerTable t = mesh.table();
        vertices = new int[t.faces()][];
        wedges = new int[t.faces()][];
        for (int v = 0; v < t.vertices(); v++) facesAbout.add(new HashSet<>());
        for (int f = 0; f < t.faces(); f++) {
            int c = CornerTable.STRIDE * f;
            if (t.vertex(c) < CornerTable.OUTSIDE) continue;
            wedges[f] = isReal(f) ? new int[] {mesh.wedge(c), mesh.wedge(c + 1), mesh.wedge(c + 2)} : null;
            place(f, t.vertex(c), t.vertex(c + 1), t.vertex(c + 2));
        }
    }

    private void place(int face, int... corners) {
        vertices[face] = corners;
        for (int v : corners) if (v != CornerTable.OUTSIDE) facesAbout.get(v).add(face);
    }

    /** Undoes a pass and checks that the stars of its vertices share no face. */
    void undoPass(int pass) {
        Set<Integer> used = new HashSet<>();
        for (int p = log.passStart(pass + 1) - 1; p >= log.passStart(pass); p--) {
            undo(p);
            for (int face : facesAbout.get(log.removed(p))) {
                assertThat(used.add(face))
                        .as("face %d is in one star of pass %d", face, pass)
                        .isTrue();
            }
        }
    }

    private void undo(int p) {
        int u = log.removed(p);
        int v = log.kept(p);
        int[] run = new int[log.runLength(p)];
        assertThat(run.length).as("run of patch %d", p).isPositive();
        int face = log.runFace(p);
        for (int i = 0; i < run.length; i++) {
            run[i] = face;
            face = faceStarting(v, previous(face, v));
        }
        int first = run[0];
        int last = run[run.length - 1];
        int x0 = next(first, v);
        int xc = previous(last, v);
        int before = faceEnding(v, x0);
        int after = face;
        int left = log.leftFace(p);
        int right = log.rightFace(p);
        checkFindable(left, v, x0, first, before);
        checkFindable(right, v, xc, last, after);
        for (int i = 0; i < run.length; i++) {
            int j = corner(run[i], v);
            facesAbout.get(v).remove(run[i]);
            vertices[run[i]][j] = u;
            facesAbout.get(u).add(run[i]);
            if (isReal(run[i])) {
                wedges[run[i]][j] = mesh.hasWedges() ? log.runWedge(p, i) : mesh.vertexOf()[u]; // one wedge per vertex
            }
        }
        restore(left, u, v, x0);
        restore(right, u, xc, v);
    }

    /**
     * Where charts of a texture stay apart, the wedges of v and x in a removed face are those of a face across its edge
     * u-x or v-x.
     */
    private void checkFindable(int removed, int v, int x, int inRun, int beside) {
        if (!isReal(removed) || !mesh.hasTexture()) return;
        for (int y : new int[] {v, x}) {
            int wedge = removedWedge(removed, y);
            boolean found = isReal(inRun) && wedges[inRun][corner(inRun, y)] == wedge
                    || isReal(beside) && wedges[beside][corner(beside, y)] == wedge;
            assertThat(found)
                    .as("wedge of vertex %d in face %d is beside it", y, removed)
                    .isTrue();
        }
    }

    private void restore(int face, int... corners) {
        place(face, corners);
        if (isReal(face))
            wedges[face] =
                    Arrays.stream(corners).map(v -> removedWedge(face, v)).toArray();
    }

    /**
     * The wedge that a removed face had at a vertex in the end: the simplified mesh still holds it, and two of the
     * three vertices.
     */
    private int removedWedge(int face, int v) {
        if (!mesh.hasWedges()) return mesh.vertexOf()[v];
        int c = CornerTable.STRIDE * face;
        if (mesh.table().vertex(c + 1) == v) return mesh.wedge(c + 1);
        return mesh.wedge(mesh.table().vertex(c + 2) == v ? c + 2 : c);
    }

    private boolean isReal(int face) {
        return face < mesh.original().faces();
    }

    private int corner(int face, int v) {
        for (int i = 0; i < 3; i++) if (vertices[face][i] == v) return i;
        throw new AssertionError("face " + face + " has no vertex " + v);
    }

    private int next(int face, int v) {
        return vertices[face][(corner(face, v) + 1) % 3];
    }

    private int previous(int face, int v) {
        return vertices[face][(corner(face, v) + 2) % 3];
    }

    /** The face about v that begins with the edge v-x, counter-clockwise. */
    private int faceStarting(int v, int x) {
        return facesAbout.get(v).stream().filter(f -> next(f, v) == x).findAny().orElseThrow();
    }

    private int faceEnding(int v, int x) {
        return facesAbout.get(v).stream()
                .filter(f -> previous(f, v) == x)
                .findAny()
                .orElseThrow();
    }

    /** Fails unless every face is back with its vertices and wedges. */
    void checkOriginal() {
        Mesh original = mesh.original();
        for (int f = 0; f < original.faces(); f++) {
            assertThat(vertices[f]).as("face %d", f).isNotNull();
            int shift = 0; // a face put back begins at another corner
            while (shift < 2 && wedges[f][shift] != original.faceWedges()[3 * f]) shift++;
            for (int j = 0; j < 3; j++) {
                int k = (j + shift) % 3;
                assertThat(wedges[f][k])
                        .as("wedge of corner %d of face %d", j, f)
                        .isEqualTo(original.faceWedges()[3 * f + j]);
                assertThat(mesh.vertexOf()[vertices[f][k]])
                        .as("vertex of corner %d of face %d", j, f)
                        .isEqualTo(original.vertex(f, j));
            }
        }
    }
}
