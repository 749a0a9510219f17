package org.jsmesh.codec;

import java.util.Arrays;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.patch.PatchLog;

/**
 * What the encoder knows and the decoder learns: the patches of the current pass at each vertex of the {@link LodMesh}, and the numbering that ties the two meshes
 * together. Runs are given in slots of the ring that {@link ConnectivityCoder} walks.
 */
final class PatchPlan {
    private final PatchLog log;
    private final int[] newVertex; // fan vertex of the original → of the LodMesh
    private final int[] newFace;
    private int[] oldVertex = new int[64];
    private int[] oldFace = new int[64];
    private int[] head = new int[0]; // first pending patch of a vertex
    private int[] nextPatch = new int[0];
    private int base; // first patch of the pass
    private int[] runStart = new int[8];
    private int[] runLength = new int[8];
    private int[] runPatch = new int[8];
    private int runs;
    private int slots;
    private int current = -1;

    PatchPlan(PatchLog log, int fans, int faces) {
        this.log = log;
        newVertex = new int[fans];
        newFace = new int[faces];
        Arrays.fill(newVertex, -1);
        Arrays.fill(newFace, -1);
    }

    void number(int oldId, int newId) {
        if (newId >= oldVertex.length) oldVertex = Arrays.copyOf(oldVertex, 2 * newId);
        newVertex[oldId] = newId;
        oldVertex[newId] = oldId;
    }

    void numberFace(int oldId, int newId) {
        if (newId >= oldFace.length) oldFace = Arrays.copyOf(oldFace, 2 * newId);
        newFace[oldId] = newId;
        oldFace[newId] = oldId;
    }

    /** Follows new numbers of the LodMesh. */
    void renumber(Renumbering numbers) {
        oldVertex = numbers.vertexRows(oldVertex, 1);
        oldFace = numbers.faceRows(oldFace, 1);
        for (int v = 0; v < numbers.oldVertex.length; v++) newVertex[oldVertex[v]] = v;
        for (int f = 0; f < numbers.newFace.length; f++) newFace[oldFace[f]] = f;
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

    PatchLog log() {
        return log;
    }

    /** Makes the patches of a pass pending at the vertices that the mesh has now. */
    void loadPass(int pass, int fans) {
        if (head.length < fans) head = new int[fans];
        Arrays.fill(head, 0, fans, -1);
        base = log.passStart(pass);
        int count = log.passStart(pass + 1) - base;
        if (nextPatch.length < count) nextPatch = new int[count];
        for (int i = 0; i < count; i++) {
            int v = newVertex[log.kept(base + i)];
            nextPatch[i] = head[v];
            head[v] = i;
        }
    }

    boolean hasPending(int vertex) {
        return head[vertex] >= 0;
    }

    /** Finds the runs of the vertex' pending patches in its ring: {@code ring[slot]} is the corner of the vertex in its slot-th face. */
    void findRuns(int vertex, int[] ring, int slotCount) {
        runs = 0;
        slots = slotCount;
        for (int i = head[vertex]; i >= 0; i = nextPatch[i]) {
            if (runs == runStart.length) {
                runStart = Arrays.copyOf(runStart, 2 * runs);
                runLength = Arrays.copyOf(runLength, 2 * runs);
                runPatch = Arrays.copyOf(runPatch, 2 * runs);
            }
            int face = newFace[log.runFace(base + i)];
            int slot = 0;
            while (slot < slotCount && CornerTable.face(ring[slot]) != face) slot++;
            if (slot == slotCount)
                throw new IllegalStateException("the run of patch " + (base + i) + " does not start at its vertex");
            runStart[runs] = slot;
            runLength[runs] = log.runLength(base + i);
            runPatch[runs++] = i;
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

    /** Takes the run that was coded off the vertex' list and numbers what its split made. Returns its patch in the log. */
    int applied(int vertex, int start, int length, int newFan, int leftFace) {
        if (current < 0 || runStart[current] != start || runLength[current] != length) {
            throw new IllegalStateException(
                    "coded run " + start + "+" + length + " is not pending at vertex " + vertex);
        }
        int patch = runPatch[current];
        if (head[vertex] == patch) {
            head[vertex] = nextPatch[patch];
        } else {
            int i = head[vertex];
            while (nextPatch[i] != patch) i = nextPatch[i];
            nextPatch[i] = nextPatch[patch];
        }
        current = -1;
        number(log.removed(base + patch), newFan);
        numberFace(log.leftFace(base + patch), leftFace);
        numberFace(log.rightFace(base + patch), leftFace + 1);
        return base + patch;
    }
}
