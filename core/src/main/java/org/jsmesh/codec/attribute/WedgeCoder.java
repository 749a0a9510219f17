package org.jsmesh.codec.attribute;

import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.WedgeTruth;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the wedges of corners and the materials of faces: by reference to a neighbouring face that has the same one,
 * else with values.
 */
public final class WedgeCoder {
    /** Most wedges of a new vertex that one reference can name. */
    private static final int RECENT = 64;

    private final LodMesh mesh;
    private final ChannelCoder[] channels;
    private final WedgeTruth truth; // encoder only
    private final int materials;
    private final int[] sameMaterial = BinaryCoder.newContexts(4);
    private final IntegerModel explicitMaterial = new IntegerModel(1);
    private final int[] reference = BinaryCoder.newContexts(3 * 4 * 8);
    private final int[] continues = BinaryCoder.newContexts(4);
    private final int[] fresh = BinaryCoder.newContexts(3);
    private final int[] candidates = new int[3];
    private int candidateCount;
    private final int[] recent = new int[RECENT];
    private final int[] before = new int[ConnectivityCoder.MAX_VALENCE + 1]; // wedges of the split vertex in the run

    public WedgeCoder(LodMesh mesh, ChannelCoder[] channels, int materials, WedgeTruth truth) {
        this.mesh = mesh;
        this.channels = channels;
        this.materials = materials;
        this.truth = truth;
    }

    // --- splits ---

    /**
     * Codes what a split of v into v and u has made: the two new faces' materials and corners, and the wedges of u in
     * its run.
     */
    public void codeSplit(BinaryCoder coder, int u, int v, int leftFace, int patch) throws MalformedStreamException {
        CornerTable t = mesh.table();
        int left = CornerTable.STRIDE * leftFace; // corners v, x0, u
        int right = left + CornerTable.STRIDE; // corners v, u, xc
        int first = t.swing(left + 2);
        int length = 0;
        for (int c = first; c != right + 1; c = t.swing(c)) before[length++] = isReal(c) ? mesh.wedge(c) : -1;
        int last = t.swingBack(right + 1);
        codeMaterials(coder, leftFace, first, last);
        if (channels.length == 0) return;
        if (isReal(left)) {
            codeFromSides(coder, left, mesh.wedge(t.swingBack(left)), before[0], v);
            codeFromSides(
                    coder,
                    left + 1,
                    mesh.wedge(CornerTable.previous(t.swingBack(left))),
                    mesh.wedge(CornerTable.next(first)),
                    t.vertex(left + 1));
        }
        if (isReal(right)) {
            codeFromSides(coder, right, mesh.wedge(t.swing(right)), before[length - 1], v);
            codeFromSides(
                    coder,
                    right + 2,
                    mesh.wedge(CornerTable.next(t.swing(right))),
                    mesh.wedge(CornerTable.previous(last)),
                    t.vertex(right + 2));
        }
        codeRun(coder, u, left, right, first, length, patch);
    }

    private void codeMaterials(BinaryCoder coder, int leftFace, int first, int last) throws MalformedStreamException {
        int left = CornerTable.STRIDE * leftFace;
        int right = left + CornerTable.STRIDE;
        CornerTable t = mesh.table();
        if (isReal(left)) codeMaterial(coder, leftFace, CornerTable.face(t.swingBack(left)), CornerTable.face(first));
        if (isReal(right)) codeMaterial(coder, leftFace + 1, CornerTable.face(t.swing(right)), CornerTable.face(last));
    }

    private boolean isReal(int corner) {
        return !mesh.table().isDummy(CornerTable.face(corner));
    }

    /**
     * Codes the wedges of u, face by face from the left one to the right one: continued, one of u's earlier ones, or
     * new.
     */
    private void codeRun(BinaryCoder coder, int u, int left, int right, int first, int length, int patch)
            throws MalformedStreamException {
        CornerTable t = mesh.table();
        candidateCount = 0;
        int known = mesh.isStitched(u) ? recall(mesh.vertexOf(u)) : 0;
        int previous = -1;
        int previousBefore = -1;
        int previousFace = -1;
        int c = left + 2;
        for (int i = -1; i <= length; i++, c = t.swing(c)) {
            if (!isReal(c)) continue;
            int now = i < 0 ? mesh.wedge(left) : i == length ? mesh.wedge(right) : before[i];
            int truthWedge = truth == null ? -1 : i < 0 || i == length ? truth.wedge(c) : truth.runWedge(patch, i);
            int wedge = -1;
            if (previous >= 0) {
                int context = (now == previousBefore ? 0 : 1)
                        + (mesh.material(CornerTable.face(c)) == mesh.material(previousFace) ? 0 : 2);
                if (coder.bit(continues, context, truth != null && truth.is(previous, truthWedge) ? 1 : 0) != 0)
                    wedge = previous;
                else if (known > 1) wedge = codeRecent(coder, 0, known, truthWedge);
            } else if (known > 0) {
                wedge = codeRecent(coder, 1, known, truthWedge);
            }
            if (wedge < 0) {
                wedge = mesh.addWedge(mesh.vertexOf(u));
                predictRun(c, i, length, now, left, right);
                codeValues(coder, wedge, truthWedge);
                if (known < RECENT) recent[known++] = wedge;
            }
            mesh.setWedge(c, wedge);
            previous = wedge;
            previousBefore = now;
            previousFace = CornerTable.face(c);
        }
    }

    /**
     * Lists wedges of a mesh vertex that has other fans, the last ones first, without the candidates. Returns how many.
     */
    private int recall(int vertex) {
        int known = 0;
        for (int w = mesh.lastWedge(vertex); w >= 0 && known < RECENT; w = mesh.wedgeBefore(w)) {
            boolean isCandidate = false;
            for (int i = 0; i < candidateCount; i++) if (candidates[i] == w) isCandidate = true;
            if (!isCandidate) recent[known++] = w;
        }
        return known;
    }

    private int codeRecent(BinaryCoder coder, int context, int known, int truthWedge) {
        int at = -1;
        for (int i = 0; i < known && truth != null; i++) if (truth.is(recent[i], truthWedge)) at = i;
        if (coder.bit(fresh, context, at < 0 ? 1 : 0) != 0) return -1;
        return recent[coder.uniform(at, known)];
    }

    /** Predicts a new wedge of u from the other two corners of the faces that had the same wedge of v. */
    private void predictRun(int corner, int i, int length, int now, int left, int right) {
        for (ChannelCoder channel : channels) channel.beginPrediction();
        int c = corner;
        for (int j = i; j <= length && isReal(c); j++, c = mesh.table().swing(c)) {
            int other = j < 0 ? mesh.wedge(left) : j == length ? mesh.wedge(right) : before[j];
            if (other != now) break;
            predictFromFace(c);
        }
    }

    /** Adds the other two corners of a face to the predictions. */
    private void predictFromFace(int corner) {
        int a = mesh.wedge(CornerTable.next(corner));
        int b = mesh.wedge(CornerTable.previous(corner));
        for (ChannelCoder channel : channels) {
            if (a >= 0) channel.predictFrom(a);
            if (b >= 0) channel.predictFrom(b);
        }
    }

    // --- base ---

    /**
     * Codes material and wedges of a face of the base, or of a component that comes later, given that all faces with
     * smaller ids are known.
     *
     * @param lastWedge the last one of each fan vertex from {@code firstFan} on, or −1
     */
    public void codeBaseFace(BinaryCoder coder, int face, int[] lastWedge, int firstFan)
            throws MalformedStreamException {
        CornerTable t = mesh.table();
        int near = -1;
        int further = -1;
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++) {
            int other = CornerTable.face(t.swing(c));
            if (t.isDummy(other) || other >= face) continue;
            if (near < 0) near = other;
            else further = other;
        }
        codeMaterial(coder, face, near, further);
        if (channels.length == 0) return;
        for (int c = CornerTable.STRIDE * face; c < CornerTable.STRIDE * face + 3; c++) {
            int fan = t.vertex(c) - firstFan;
            candidateCount = 0;
            addCandidate(mesh.wedge(t.swing(c)));
            addCandidate(mesh.wedge(t.swingBack(c)));
            addCandidate(lastWedge[fan]);
            lastWedge[fan] = codeCandidates(coder, c, t.vertex(c), 2);
        }
    }

    // --- both ---

    private void codeMaterial(BinaryCoder coder, int face, int near, int further) throws MalformedStreamException {
        if (materials == 0) return;
        CornerTable t = mesh.table();
        int wanted = truth == null ? -1 : truth.material(face);
        int a = near >= 0 && !t.isDummy(near) ? mesh.material(near) : -2;
        int b = further >= 0 && !t.isDummy(further) ? mesh.material(further) : -2;
        int chosen = -2;
        if (a != -2 && coder.bit(sameMaterial, a == b ? 0 : b == -2 ? 1 : 2, wanted == a ? 1 : 0) != 0) chosen = a;
        else if (b != -2 && b != a && coder.bit(sameMaterial, 3, wanted == b ? 1 : 0) != 0) chosen = b;
        if (chosen == -2) chosen = explicitMaterial.unsigned(coder, wanted + 1) - 1;
        if (chosen >= materials) throw new MalformedStreamException(-1, "material " + chosen + " of " + materials);
        mesh.setMaterial(face, chosen);
    }

    private void codeFromSides(BinaryCoder coder, int corner, int outer, int inner, int fan)
            throws MalformedStreamException {
        candidateCount = 0;
        addCandidate(outer);
        addCandidate(inner);
        codeCandidates(coder, corner, fan, outer == inner ? 0 : 1);
    }

    private void addCandidate(int wedge) {
        if (wedge < 0) return;
        for (int i = 0; i < candidateCount; i++) if (candidates[i] == wedge) return;
        candidates[candidateCount++] = wedge;
    }

    private int codeCandidates(BinaryCoder coder, int corner, int fan, int kind) throws MalformedStreamException {
        int wanted = truth == null ? -1 : truth.wedge(corner);
        int wedge = -1;
        for (int i = 0; i < candidateCount && wedge < 0; i++) {
            int context = (kind * 4 + candidateCount) * 4 + i;
            if (coder.bit(reference, context, truth != null && truth.is(candidates[i], wanted) ? 1 : 0) != 0)
                wedge = candidates[i];
        }
        if (wedge < 0 && mesh.isStitched(fan)) {
            int known = recall(mesh.vertexOf(fan));
            if (known > 0) wedge = codeRecent(coder, 2, known, wanted);
        }
        if (wedge < 0) {
            wedge = mesh.addWedge(mesh.vertexOf(fan));
            for (ChannelCoder channel : channels) channel.beginPrediction();
            predictFromFace(corner);
            codeValues(coder, wedge, wanted);
        }
        mesh.setWedge(corner, wedge);
        return wedge;
    }

    private void codeValues(BinaryCoder coder, int wedge, int originalWedge) throws MalformedStreamException {
        for (ChannelCoder channel : channels) channel.code(coder, wedge, originalWedge);
        if (truth != null) truth.number(originalWedge, wedge);
    }
}
