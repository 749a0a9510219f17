package org.jsmesh.codec.connectivity;

import java.util.Arrays;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.Renumbering;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.patch.PatchLog;

/**
 * What the encoder knows and the decoder learns: the patches of the current pass at each vertex of the {@link LodMesh},
 * and the numbering that ties the two meshes together. Runs are given in slots of the ring that
 * {@link ConnectivityCoder} walks.
 */
public final class PatchPlan {
    // what is known of pending patches, vertex after vertex, because the log has them scattered
    private static final int PATCH = 0;
    private static final int RUN_FACE = 1; // of the LodMesh
    private static final int RUN_LENGTH = 2;
    private static final int REMOVED = 3;
    private static final int LEFT_FACE = 4;
    private static final int RIGHT_FACE = 5;
    private static final int FIELDS = 6;

    private final PatchLog log;
    private final boolean needsFaces;
    private final int[] newVertex; // fan vertex of the original → of the LodMesh; empty where nobody asks
    private final int[] newFace;
    private int[] oldVertex;
    private int[] oldFace; // only where they will be asked for
    private int[] pending = new int[0];
    private int[] begin = new int[0]; // per vertex of the LodMesh: its patches in pending
    private int[] end = new int[0];
    private int[] runStart = new int[8];
    private int[] runLength = new int[8];
    private int runs;
    private int first; // of the vertex' patches
    private int slots;
    private int current = -1;

    /**
     * @param needsVertices whether the LodMesh's ids of vertices will be asked for
     * @param codedFaces faces of the LodMesh whose ids in the original will be asked for, or 0
     */
    PatchPlan(PatchLog log, int fans, boolean needsVertices, int faces, int codedFaces) {
        this.log = log;
        newVertex = new int[needsVertices ? fans : 0];
        newFace = new int[faces];
        oldVertex = new int[fans];
        oldFace = new int[codedFaces];
        needsFaces = codedFaces > 0;
        Arrays.fill(newVertex, -1);
        Arrays.fill(newFace, -1);
    }

    void number(int oldId, int newId) {
        if (newVertex.length > 0) newVertex[oldId] = newId;
        oldVertex[newId] = oldId;
    }

    void numberFace(int oldId, int newId) {
        newFace[oldId] = newId;
        if (needsFaces) oldFace[newId] = oldId;
    }

    /** Follows new numbers of the LodMesh. */
    public void renumber(Renumbering numbers) {
        oldVertex = numbers.vertexRows(oldVertex, 1);
        if (needsFaces) oldFace = numbers.faceRows(oldFace, 1);
        for (int v = 0; v < numbers.oldVertex.length && newVertex.length > 0; v++) newVertex[oldVertex[v]] = v;
        for (int f = 0; f < newFace.length; f++) if (newFace[f] >= 0) newFace[f] = numbers.newFace[newFace[f]];
    }

    int oldVertex(int newId) {
        return oldVertex[newId];
    }

    int oldFace(int newId) {
        return oldFace[newId];
    }

    int newFace(int oldId) {
        return newFace[oldId];
    }

    int newVertex(int oldId) {
        return newVertex[oldId];
    }

    public PatchLog log() {
        return log;
    }

    /**
     * Makes the patches of a pass pending at the vertices that the mesh has now. Those of a vertex go from the last in
     * the log to the first.
     */
    public void loadPass(int pass, int fans) {
        int base = log.passStart(pass);
        int behind = log.passStart(pass + 1);
        if (base == behind) return; // nobody will ask
        if (begin.length < fans) {
            begin = new int[Math.min(newVertex.length, 2 * fans)];
            end = new int[begin.length];
        }
        if (pending.length < FIELDS * (behind - base)) pending = new int[FIELDS * (behind - base)];
        Arrays.fill(end, 0, fans, 0);
        for (int p = base; p < behind; p++) end[newVertex[log.kept(p)]]++;
        for (int v = 0, at = 0; v < fans; v++) {
            int count = end[v];
            begin[v] = at;
            end[v] = at;
            at += count;
        }
        for (int p = behind - 1; p >= base; p--) {
            int at = FIELDS * end[newVertex[log.kept(p)]]++;
            pending[at + PATCH] = p;
            pending[at + RUN_FACE] = newFace[log.runFace(p)];
            pending[at + RUN_LENGTH] = log.runLength(p);
            pending[at + REMOVED] = log.removed(p);
            pending[at + LEFT_FACE] = log.leftFace(p);
            pending[at + RIGHT_FACE] = log.rightFace(p);
        }
    }

    boolean hasPending(int vertex) {
        return begin[vertex] < end[vertex];
    }

    /**
     * Finds the runs of the vertex' pending patches in its ring: {@code ring[slot]} is the corner of the vertex in its
     * slot-th face.
     */
    void findRuns(int vertex, int[] ring, int slotCount) {
        first = begin[vertex];
        runs = end[vertex] - first;
        slots = slotCount;
        if (runs > runStart.length) {
            runStart = new int[2 * runs];
            runLength = new int[2 * runs];
        }
        for (int i = 0; i < runs; i++) {
            int at = FIELDS * (first + i);
            int face = pending[at + RUN_FACE];
            int slot = 0;
            while (slot < slotCount && CornerTable.face(ring[slot]) != face) slot++;
            if (slot == slotCount)
                throw new IllegalStateException(
                        "the run of patch " + pending[at + PATCH] + " does not start at its vertex");
            runStart[i] = slot;
            runLength[i] = pending[at + RUN_LENGTH];
        }
    }

    /** Is there a pending run of two or more faces? */
    boolean hasLongRun() {
        for (int i = 0; i < runs; i++) if (runLength[i] > 1) return true;
        return false;
    }

    /** Does the edge before this slot lie within a long run? Remembers the run. */
    boolean isInterior(int edge) {
        for (int i = 0; i < runs; i++) {
            if (covers(i, edge)) {
                current = i;
                return true;
            }
        }
        return false;
    }

    /** Does the edge before this slot lie within the run remembered? */
    boolean isInteriorOfCurrent(int edge) {
        return covers(current, edge);
    }

    private boolean covers(int run, int edge) {
        int distance = edge - runStart[run];
        if (distance < 0) distance += slots;
        return distance >= 1 && distance < runLength[run];
    }

    /** Slot of a pending run of one face. */
    int shortRun() {
        for (int i = 0; i < runs; i++) {
            if (runLength[i] == 1) {
                current = i;
                return runStart[i];
            }
        }
        throw new IllegalStateException("no short run");
    }

    /** Removes the coded run from the vertex' list and numbers what its split made. Returns its patch in the log. */
    int applied(int vertex, int start, int length, int newFan, int leftFace) {
        if (current < 0 || runStart[current] != start || runLength[current] != length) {
            throw new IllegalStateException(
                    "coded run " + start + "+" + length + " is not pending at vertex " + vertex);
        }
        int at = FIELDS * (first + current);
        int patch = pending[at + PATCH];
        number(pending[at + REMOVED], newFan);
        numberFace(pending[at + LEFT_FACE], leftFace);
        numberFace(pending[at + RIGHT_FACE], leftFace + 1);
        int left = FIELDS * --end[vertex] - at;
        if (left > 0) System.arraycopy(pending, at + FIELDS, pending, at, left);
        current = -1;
        return patch;
    }
}
