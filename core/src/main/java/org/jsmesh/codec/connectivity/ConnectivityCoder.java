package org.jsmesh.codec.connectivity;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.ArrayGrowth;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.Renumbering;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.patch.VertexSplit;

/**
 * Codes which vertices split and which of their faces the new vertex takes, and applies the splits.
 *
 * <p>Vertices are visited in order; a flag per visit says whether another split follows, in the context of valence,
 * faces still free in this pass, and age. {@link RunCoder} has the run of faces.
 */
public final class ConnectivityCoder {
    /** A vertex with more faces than this is not split. */
    public static final int MAX_VALENCE = 64;

    /** Valence of an inner vertex of a regular mesh. */
    static final int REGULAR = 6;

    private static final int AGE = 7; // passes since the vertex was last touched, and the mask of it
    private static final int VALENCE_AT = 3;
    private static final int MOST_COUNTED = 255; // of the valence; a vertex with that many faces does not split
    private static final int USED_AT = 11;
    private final LodMesh mesh;
    private final int[] flagByHistory = BinaryCoder.newContexts(2 * 13 * 13 * 16);
    private final int[] flagByAge = BinaryCoder.newContexts(2 * 8 * 13 * 13);
    private final SplitRing ring;
    private final RunCoder runs;
    private int[] state = new int[0]; // per vertex: faces used in this pass, valence, age
    private int[] next = new int[64]; // the vertices in an order that keeps neighbours together, −1 at the end
    private int pass;
    private int last; // in that order
    private int fansBefore;
    private int vertex;
    private int splitsHere;
    private int history;
    private int slots;
    private int free;
    private int start;
    private int length;
    private int patch;
    private final SplitLane lane;
    private final StitchCoder stitches; // or null

    /**
     * @param lane receives the rings of the vertices that splits make
     * @param stitches null where there are none
     */
    public ConnectivityCoder(LodMesh mesh, SplitLane lane, StitchCoder stitches) {
        this.mesh = mesh;
        this.lane = lane;
        this.stitches = stitches;
        ring = new SplitRing(mesh);
        runs = new RunCoder(ring);
    }

    /** Has the first pass begun? */
    public boolean hasBegun() {
        return pass > 0;
    }

    public void beginPass() {
        pass++;
        fansBefore = mesh.fans();
        vertex = 0;
        splitsHere = 0;
        history = 0;
        if (pass == 1) beginFirstPass();
        for (int v = 0; v < fansBefore; v++) {
            int known = state[v] & (1 << USED_AT) - 1;
            state[v] = (known & AGE) == AGE ? known : known + 1;
        }
    }

    private void beginFirstPass() {
        if (next.length < fansBefore) next = new int[fansBefore];
        order();
        state = new int[fansBefore];
        countFaces(0);
    }

    private void countFaces(int from) {
        for (int v = from; v < mesh.fans(); v++)
            state[v] = Math.min(mesh.table().valence(v), MOST_COUNTED) << VALENCE_AT;
    }

    /** Takes in the fan vertices of a new component, from a number on. They do not split in this pass. */
    public void addComponent(int first) {
        int fans = mesh.fans();
        if (fans > state.length) state = ArrayGrowth.rows(state, 1, fans, mesh.expectedFans());
        if (fans > next.length) next = ArrayGrowth.rows(next, 1, fans, mesh.expectedFans());
        countFaces(first);
        for (int v = first; v < fans; v++) {
            next[last] = v;
            next[v] = -1;
            last = v;
        }
    }

    private void order() {
        for (int v = 0; v < fansBefore; v++) next[v] = v + 1;
        last = fansBefore - 1;
        next[last] = -1;
    }

    /** New numbers that put each new vertex behind the one that was split. */
    public Renumbering renumbering() {
        return new Renumbering(mesh.table(), next);
    }

    /** Follows new numbers, before a pass. */
    public void renumber(Renumbering numbers) {
        state = numbers.vertexRows(state, 1);
        fansBefore = mesh.fans();
        order();
    }

    /** Codes and applies the next split of the pass and returns the new vertex. */
    public int codeSplit(BinaryCoder coder, PatchPlan plan) throws MalformedStreamException {
        boolean encoder = coder.isEncoder();
        while (true) {
            if (vertex >= fansBefore)
                throw new MalformedStreamException(-1, "a pass has more vertex splits than its vertices allow");
            int known = state[vertex];
            slots = valence(known);
            free = Math.min(slots - (known >>> USED_AT), slots - 1);
            if (free > 0 && slots <= MAX_VALENCE) {
                int valence = Math.min(slots, 12);
                int frees = Math.min(free, 12);
                int repeat = Math.min(splitsHere, 1);
                int age = known & AGE;
                int flag = coder.bit(
                        flagByHistory,
                        ((repeat * 13 + valence) * 13 + frees) * 16 + (history & 15),
                        flagByAge,
                        ((repeat * 8 + age) * 13 + valence) * 13 + frees,
                        encoder && plan.hasPending(vertex) ? 1 : 0);
                history = history << 1 | flag;
                if (flag != 0) {
                    splitsHere++;
                    return codeRun(coder, plan);
                }
            }
            vertex++;
            splitsHere = 0;
        }
    }

    private int codeRun(BinaryCoder coder, PatchPlan plan) {
        int candidates = ring.measure(vertex, slots, pass, state);
        if (coder.isEncoder()) plan.findRuns(vertex, ring.corner, slots);
        runs.code(coder, plan, slots, candidates);
        start = runs.start();
        length = runs.length();
        return apply(coder, plan);
    }

    private int apply(BinaryCoder coder, PatchPlan plan) {
        CornerTable t = mesh.table();
        int end = start + length - 1;
        if (end >= slots) end -= slots;
        int v = vertex;
        int leftFace = t.faces();
        mesh.growTable();
        int u = VertexSplit.apply(t, ring.corner[start], ring.corner[end]);
        mesh.growWedges();
        int[] data = t.data();
        data[CornerTable.STRIDE * leftFace + 3] = pass;
        data[CornerTable.STRIDE * leftFace + 11] = pass;
        if (u == state.length) state = ArrayGrowth.rows(state, 1, u + 1, mesh.expectedFans());
        if (u == next.length) next = ArrayGrowth.rows(next, 1, u + 1, mesh.expectedFans());
        next[u] = next[v];
        next[v] = u;
        if (v == last) last = u;
        state[u] = (length + 2 << USED_AT) + (length + 2 << VALENCE_AT);
        state[v] += (2 - length << VALENCE_AT);
        use(v, 2);
        lane.beginRing();
        boolean tellsBeyond = lane.wantsBeyond(length + 2);
        for (int i = 0, j = start; i <= length; i++, j = j + 1 == slots ? 0 : j + 1) {
            lane.addToRing(ring.neighbour[j]);
            if (i < length) {
                int c = ring.corner[j];
                data[c | 3] = pass;
                if (tellsBeyond) lane.addBeyond(i, beyond(data, c));
            }
            if (ring.neighbour[j] >= 0) use(ring.neighbour[j], 2);
        }
        addFace(ring.neighbour[start]);
        addFace(ring.neighbour[end + 1 == slots ? 0 : end + 1]);
        lane.addToRing(v);
        if (tellsBeyond) {
            lane.addBeyond(length, ring.neighbour[end + 2 >= slots ? end + 2 - slots : end + 2]);
            lane.addBeyond(length + 1, ring.neighbour[start == 0 ? slots - 1 : start - 1]);
        }
        lane.endSplit(v);
        boolean leftDummy = t.isDummy(leftFace);
        boolean rightDummy = t.isDummy(leftFace + 1);
        mesh.countFaces((leftDummy ? 0 : 1) + (rightDummy ? 0 : 1));
        patch = plan == null ? -1 : plan.applied(v, start, length, u, leftFace);
        mesh.addFan(stitches == null ? mesh.addVertex() : stitches.code(coder, u));
        return u;
    }

    /** The vertex beyond the edge that is opposite a corner. Later splits of the pass change that. */
    private static int beyond(int[] data, int corner) {
        return data[CornerTable.previous(data[CornerTable.previous(corner) + 4])];
    }

    /** Counts faces of a vertex that this pass has used, and sets its age to 0. */
    private void use(int v, int faces) {
        state[v] = (state[v] & ~AGE) + (faces << USED_AT);
    }

    private void addFace(int v) {
        if (v >= 0 && valence(state[v]) < MOST_COUNTED) state[v] += 1 << VALENCE_AT;
    }

    /** Faces about a vertex, dummy ones too, as its state counts them. */
    static int valence(int state) {
        return state >> VALENCE_AT & MOST_COUNTED;
    }

    /** The patch of the last split in the encoder's log. */
    public int patch() {
        return patch;
    }
}
