package org.jsmesh.encode.write;

import java.util.Arrays;
import java.util.BitSet;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.ManifoldCut;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.patch.PatchLog;

/**
 * The faces of coarse levels, from finer to coarser ones. They are found from where the collapses have left their
 * vertices, without undoing any collapse.
 */
final class CoarseLevels {
    private final CodedMesh source;
    private final Mesh mesh;
    private final CornerTable cut; // of the original where vertices have several fans, else null
    private final PatchLog log;
    private final BitSet found = new BitSet(); // faces of components that were removed
    private final int[] kept; // per fan vertex: the vertex that it collapsed into, or −1
    private int collapsed; // patches that are not undone in the present level
    private int faces;
    private int[] corners = new int[3 * 256]; // fan vertices, three per face
    private int[] goneIn = new int[256]; // pass that removed the face

    /** @param pass before which the finest of the levels is shown */
    CoarseLevels(CodedMesh source, int pass) {
        this.source = source;
        mesh = source.original();
        log = source.log();
        int fans = source.vertexOf().length;
        cut = fans == mesh.vertices() ? null : log.size() == 0 ? source.table() : new ManifoldCut(mesh).table();
        kept = new int[fans];
        Arrays.fill(kept, -1);
        for (int f = 0; f < mesh.faces(); f++) if (source.isLiveFace(f)) add(f, log.passes());
        for (int later = pass + 1; later < log.passes(); later++) {
            for (int p = log.passStart(later); p < log.passStart(later + 1); p++) {
                add(log.leftFace(p), later);
                add(log.rightFace(p), later);
            }
            for (int i = log.componentStart(later); i < log.componentStart(later + 1); i++)
                addComponent(log.componentFace(i), later);
        }
        goTo(pass);
    }

    private void add(int face, int pass) {
        if (face >= mesh.faces()) return; // a dummy
        if (faces == goneIn.length) {
            goneIn = Arrays.copyOf(goneIn, 2 * faces);
            corners = Arrays.copyOf(corners, 6 * faces);
        }
        for (int j = 0; j < 3; j++)
            corners[3 * faces + j] = cut == null ? mesh.vertex(face, j) : cut.vertex(CornerTable.STRIDE * face + j);
        goneIn[faces++] = pass;
    }

    /** Adds what was left of a component when it was removed whole. */
    private void addComponent(int face, int pass) {
        CornerTable table = source.table();
        int[] open = {face};
        int n = 1;
        found.set(face);
        for (int i = 0; i < n; i++) {
            add(open[i], pass);
            for (int j = 0; j < 3; j++) {
                int other = CornerTable.face(table.swing(CornerTable.STRIDE * open[i] + j));
                if (table.isDummy(other) || found.get(other)) continue;
                found.set(other);
                if (n == open.length) open = Arrays.copyOf(open, 2 * n);
                open[n++] = other;
            }
        }
    }

    /** Goes to a coarser level: the level before an earlier pass of the decoder. */
    void goTo(int pass) {
        int end = log.passStart(pass + 1);
        for (; collapsed < end; collapsed++) kept[log.removed(collapsed)] = log.kept(collapsed);
        int n = 0;
        for (int f = 0; f < faces; f++) {
            if (goneIn[f] <= pass) continue;
            for (int j = 0; j < 3; j++) corners[3 * n + j] = present(corners[3 * f + j]);
            goneIn[n++] = goneIn[f];
        }
        faces = n;
    }

    /** The fan vertex that a fan vertex has become. Shortens the chain for the next call. */
    private int present(int fan) {
        int v = fan;
        while (kept[v] >= 0) {
            int next = kept[v];
            if (kept[next] >= 0) kept[v] = kept[next];
            v = next;
        }
        return v;
    }

    /** Three vertices of the original per face. */
    int[] triangles() {
        int[] triangles = new int[3 * faces];
        for (int i = 0; i < triangles.length; i++) triangles[i] = source.vertexOf()[corners[i]];
        return triangles;
    }
}
