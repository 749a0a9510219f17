package org.jsmesh.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Drops what no face refers to (vertices, wedges, materials) and merges wedges of a vertex that have the same
 * attributes. Vertices keep their order; equal positions are not merged. A mesh in which there is nothing to do is
 * returned as it is.
 */
public final class MeshCleaner {
    private final Mesh mesh;
    private final List<Note> notes;

    private MeshCleaner(Mesh mesh, List<Note> notes) {
        this.mesh = mesh;
        this.notes = notes;
    }

    /**
     * Cleans a mesh.
     *
     * @param mesh any mesh; it stays as it is
     * @param notes receives what is dropped
     * @return a clean mesh, which may be the same one
     */
    public static Mesh clean(Mesh mesh, List<Note> notes) {
        return new MeshCleaner(mesh, notes).run();
    }

    private Mesh run() {
        int[] wedges = mesh.faceWedges();
        int[] representative = mesh.channels().isEmpty() && areVertices() ? null : mergedWedges();
        int[] newVertex = new int[mesh.vertices()];
        int[] newWedge = representative == null ? newVertex : new int[mesh.wedges()];
        Arrays.fill(newVertex, -1);
        Arrays.fill(newWedge, -1);
        for (int w : wedges) {
            newWedge[representative == null ? w : representative[w]] = 0;
            newVertex[mesh.wedgeVertices()[w]] = 0;
        }
        int vertices = enumerate(newVertex);
        int kept = representative == null ? vertices : enumerate(newWedge);
        if (vertices == mesh.vertices() && kept == mesh.wedges() && usesAllMaterials()) return mesh;
        if (vertices < mesh.vertices())
            note(
                    mesh.vertices() - vertices,
                    "vertex",
                    "vertices",
                    "that no face refers to",
                    "vertex " + first(newVertex));

        float[] positions = new float[3 * vertices];
        double[] exact = mesh.exactPositions() == null ? null : new double[3 * vertices];
        for (int v = 0; v < newVertex.length; v++) {
            if (newVertex[v] < 0) continue;
            System.arraycopy(mesh.positions(), 3 * v, positions, 3 * newVertex[v], 3);
            if (exact != null) System.arraycopy(mesh.exactPositions(), 3 * v, exact, 3 * newVertex[v], 3);
        }
        int[] wedgeVertices = new int[kept];
        int[] oldWedge = new int[kept];
        for (int w = 0; w < newWedge.length; w++) {
            if (newWedge[w] < 0) continue;
            wedgeVertices[newWedge[w]] = newVertex[mesh.wedgeVertices()[w]];
            oldWedge[newWedge[w]] = w;
        }
        int[] faceWedges = new int[wedges.length];
        for (int i = 0; i < wedges.length; i++)
            faceWedges[i] = newWedge[representative == null ? wedges[i] : representative[wedges[i]]];
        List<Channel> channels = new ArrayList<>();
        for (Channel c : mesh.channels()) channels.add(pick(c, oldWedge));
        MeshBuilder builder = MeshBuilder.from(mesh)
                .offsets(mesh.origin(), positions, exact)
                .wedgeVertices(wedgeVertices)
                .faceWedges(faceWedges)
                .channels(channels);
        cleanMaterials(builder);
        return builder.build();
    }

    /** Is every wedge the vertex of the same number? */
    private boolean areVertices() {
        int[] vertices = mesh.wedgeVertices();
        if (vertices.length != mesh.vertices()) return false;
        for (int w = 0; w < vertices.length; w++) if (vertices[w] != w) return false;
        return true;
    }

    private boolean usesAllMaterials() {
        boolean[] used = new boolean[mesh.materials().size()];
        int left = used.length;
        for (int f = 0; f < mesh.faces() && left > 0; f++) {
            int m = mesh.faceMaterials()[f];
            if (m < 0 || used[m]) continue;
            used[m] = true;
            left--;
        }
        return left == 0;
    }

    private static int enumerate(int[] marks) {
        int n = 0;
        for (int i = 0; i < marks.length; i++) if (marks[i] >= 0) marks[i] = n++;
        return n;
    }

    private void note(int count, String one, String many, String which, String first) {
        notes.add(Note.dropped(count + " " + (count == 1 ? one : many) + " " + which + " dropped.", count, first));
    }

    /** The first that does not stay. */
    private static int first(int[] renumbered) {
        int first = 0;
        while (renumbered[first] >= 0) first++;
        return first;
    }

    private static Channel pick(Channel c, int[] oldWedge) {
        int k = c.words();
        int[] values = new int[k * oldWedge.length];
        BitSet absent = new BitSet();
        for (int w = 0; w < oldWedge.length; w++) {
            if (c.isAbsent(oldWedge[w])) absent.set(w);
            else System.arraycopy(c.values(), k * oldWedge[w], values, k * w, k);
        }
        return c.withValues(values, absent);
    }

    /** The first wedge with the same vertex and attributes as each wedge. */
    private int[] mergedWedges() {
        int width = 1;
        for (Channel c : mesh.channels()) width += c.words() + 1;
        int n = mesh.wedges();
        int[] rows = new int[Sizes.of(width, n, "different corners of " + width + " numbers")];
        for (int w = 0; w < n; w++) {
            int at = width * w;
            rows[at++] = mesh.wedgeVertices()[w];
            for (Channel c : mesh.channels()) {
                boolean absent = c.isAbsent(w);
                rows[at++] = absent ? 1 : 0;
                for (int k = 0; k < c.words(); k++) rows[at++] = absent ? 0 : c.values()[c.words() * w + k];
            }
        }
        int[] order = RowSorter.order(rows, width, n);
        int[] first = new int[n];
        for (int i = 0; i < n; i++) {
            boolean same = i > 0 && RowSorter.equal(rows, width, order[i - 1], order[i]);
            first[order[i]] = same ? first[order[i - 1]] : order[i];
        }
        return first;
    }

    private void cleanMaterials(MeshBuilder builder) {
        int[] newMaterial = new int[mesh.materials().size()];
        Arrays.fill(newMaterial, -1);
        for (int m : mesh.faceMaterials()) if (m >= 0) newMaterial[m] = 0;
        enumerate(newMaterial);
        List<Material> kept = new ArrayList<>();
        for (int m = 0; m < newMaterial.length; m++)
            if (newMaterial[m] >= 0) kept.add(mesh.materials().get(m));
        if (kept.size() < newMaterial.length) {
            String first = mesh.materials().get(first(newMaterial)).name();
            note(newMaterial.length - kept.size(), "material", "materials", "that no face uses", first);
        }
        int[] faceMaterials = mesh.faceMaterials().clone();
        for (int f = 0; f < faceMaterials.length; f++)
            if (faceMaterials[f] >= 0) faceMaterials[f] = newMaterial[faceMaterials[f]];
        builder.materials(kept).faceMaterials(faceMaterials);
    }
}
