package org.jsmesh.codec.connectivity;

import java.util.Arrays;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.EdgeMap;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the connectivity of the base mesh, and of components that come later. It goes component by component, across
 * open edges in the order in which they were opened. Behind each edge lies a boundary, a new vertex, one of the two
 * vertices that close the gap at the edge's ends, or any other vertex.
 */
public final class BaseCoder {
    private static final int FEW_EDGES = 64;
    private final int[] boundary = BinaryCoder.newContexts(2);
    private final int[] isNew = BinaryCoder.newContexts(2);
    private final int[] closes = BinaryCoder.newContexts(4);
    private int mostFaces;
    private int mostFans;
    private int[] corner = new int[96]; // fan vertex of corner 3 f + j
    private int[] opposite = new int[96]; // −1: boundary, −2: open
    private int[] openOut = new int[32]; // an open edge that leaves a vertex
    private int[] openIn = new int[32];
    private EdgeMap edges = new EdgeMap(FEW_EDGES);
    private final BaseListener listener;
    private int faceCount;
    private int fanCount;

    /** Is told of every new vertex, in coding order. */
    public interface BaseListener {
        /**
         * @param fan the new vertex
         * @param a, b, c corners of the face across the gate (a→b is the gate, c opposite), or −1
         */
        void added(int fan, int a, int b, int c) throws MalformedStreamException;
    }

    public BaseCoder(BaseListener listener) {
        this.listener = listener;
    }

    /**
     * Codes so many faces and vertices, all of the base.
     *
     * @param truth the encoder's base, or null
     */
    public void code(BinaryCoder coder, BaseTruth truth, int faces, int fans) throws MalformedStreamException {
        begin(faces, fans);
        while (faceCount < faces) codeComponent(coder, truth);
        if (fanCount != fans)
            throw new MalformedStreamException(-1, "the base has " + fanCount + " vertices of " + fans);
    }

    /** Codes a single component of at most so many faces; faces and vertices are numbered from 0 again. */
    public void codeOne(BinaryCoder coder, BaseTruth truth, int most) throws MalformedStreamException {
        begin(most, Integer.MAX_VALUE);
        if (most < 1) throw new MalformedStreamException(-1, "there are more components than faces");
        codeComponent(coder, truth);
    }

    private void begin(int faces, int fans) {
        mostFaces = faces;
        mostFans = fans;
        if (faceCount > FEW_EDGES) edges = new EdgeMap(FEW_EDGES);
        else edges.clear();
        faceCount = 0;
        fanCount = 0;
    }

    private void codeComponent(BinaryCoder coder, BaseTruth truth) throws MalformedStreamException {
        int gate = 3 * faceCount;
        int seed = truth == null ? 0 : truth.nextComponent();
        addFace(newFan(truth, seed, 0, -1), newFan(truth, seed, 1, -1), newFan(truth, seed, 2, -1), truth, seed, 0);
        for (; gate < 3 * faceCount; gate++) {
            if (coder.isExhausted()) throw new MalformedStreamException(-1, "the base ends early");
            if (opposite[gate] == -2) codeGate(coder, gate, truth);
        }
    }

    /** Faces that were coded last. */
    public int faces() {
        return faceCount;
    }

    /** Faces that were coded last, and the dummy faces behind their boundaries. */
    public int allFaces() {
        int all = faceCount;
        for (int h = 0; h < 3 * faceCount; h++) if (opposite[h] < 0) all++;
        return all;
    }

    private int newFan(BaseTruth truth, int oldFace, int oldCorner, int gate) throws MalformedStreamException {
        if (fanCount == mostFans) throw new MalformedStreamException(-1, "the base has more vertices than it claims");
        int fan = fanCount++;
        if (fan == openOut.length) {
            openOut = Arrays.copyOf(openOut, 2 * fan);
            openIn = Arrays.copyOf(openIn, 2 * fan);
        }
        openOut[fan] = -1;
        openIn[fan] = -1;
        if (truth != null) truth.numberFan(oldFace, oldCorner, fan);
        if (gate < 0) listener.added(fan, -1, -1, -1);
        else listener.added(fan, corner[gate], corner[next(gate)], corner[previous(gate)]);
        return fan;
    }

    private void codeGate(BinaryCoder coder, int gate, BaseTruth truth) throws MalformedStreamException {
        int a = corner[gate];
        int b = corner[next(gate)];
        int behind = truth == null ? 0 : truth.across(gate); // 3 × face + corner of b there, or −1
        if (coder.bit(boundary, 0, behind < 0 ? 1 : 0) != 0) {
            opposite[gate] = -1;
            return;
        }
        if (faceCount == mostFaces) throw new MalformedStreamException(-1, "the base has more faces than it claims");
        int oldFace = behind / 3;
        int oldTip = truth == null ? 0 : (behind + 2) % 3; // corners there are b, a, tip
        int tip = truth == null ? -1 : truth.fanAt(oldFace, oldTip);
        int fan;
        if (coder.bit(isNew, 0, tip < 0 ? 1 : 0) != 0) {
            fan = newFan(truth, oldFace, oldTip, gate);
        } else {
            fan = codeKnown(coder, a, b, tip);
        }
        if (fan == a || fan == b) throw new MalformedStreamException(-1, "a face of the base is degenerate");
        addFace(b, a, fan, truth, oldFace, behind % 3);
    }

    private int codeKnown(BinaryCoder coder, int a, int b, int tip) {
        int left = openOut[b] >= 0 && opposite[openOut[b]] == -2 ? corner[next(openOut[b])] : -1;
        int right = openIn[a] >= 0 && opposite[openIn[a]] == -2 ? corner[openIn[a]] : -1;
        if (left >= 0 && coder.bit(closes, 0, tip == left ? 1 : 0) != 0) return left;
        if (right >= 0 && right != left && coder.bit(closes, left >= 0 ? 1 : 2, tip == right ? 1 : 0) != 0)
            return right;
        return fanCount - 1 - coder.uniform(fanCount - 1 - tip, fanCount);
    }

    private void addFace(int a, int b, int c, BaseTruth truth, int oldFace, int oldCornerOfA)
            throws MalformedStreamException {
        int face = faceCount++;
        if (truth != null) truth.numberFace(oldFace, oldCornerOfA, face);
        int at = 3 * face;
        if (at == corner.length) {
            corner = Arrays.copyOf(corner, 2 * at);
            opposite = Arrays.copyOf(opposite, 2 * at);
        }
        corner[at] = a;
        corner[at + 1] = b;
        corner[at + 2] = c;
        for (int h = at; h < at + 3; h++) opposite[h] = -2;
        for (int h = at; h < at + 3; h++) glue(h);
    }

    private void glue(int h) throws MalformedStreamException {
        int from = corner[h];
        int to = corner[next(h)];
        int other = edges.put(from, to, h);
        if (other >= 0) {
            if (opposite[other] != -2 || corner[other] != to)
                throw new MalformedStreamException(-1, "an edge of the base occurs twice");
            opposite[h] = other;
            opposite[other] = h;
        } else {
            openOut[from] = h;
            openIn[to] = h;
        }
    }

    /**
     * The corner table of the base that was coded.
     *
     * @throws MalformedStreamException when the base is damaged so that a table cannot hold it
     */
    public CornerTable table() throws MalformedStreamException {
        checkBoundaries();
        CornerTable table = CornerTable.of(corner, opposite, faceCount, fanCount);
        checkFans(table, 0);
        return table;
    }

    /** Appends what was coded to a table. */
    public void appendTo(CornerTable table) throws MalformedStreamException {
        checkBoundaries();
        int first = table.vertices();
        table.append(corner, opposite, faceCount, fanCount);
        checkFans(table, first);
    }

    /** A damaged base may have more than one boundary at a vertex. */
    private void checkBoundaries() throws MalformedStreamException {
        boolean[] open = new boolean[fanCount];
        for (int h = 0; h < 3 * faceCount; h++) {
            if (opposite[h] >= 0) continue;
            int v = corner[h];
            if (open[v]) throw new MalformedStreamException(-1, "a vertex of the base has two fans");
            open[v] = true;
        }
    }

    /** A damaged base may give a vertex several fans. */
    private void checkFans(CornerTable table, int first) throws MalformedStreamException {
        int[] count = new int[fanCount];
        for (int h = 0; h < 3 * faceCount; h++) count[corner[h]]++;
        for (int v = 0; v < fanCount; v++) {
            int start = table.cornerOf(first + v);
            int n = 0;
            int c = start;
            do {
                if (!table.isDummy(CornerTable.face(c))) n++;
                c = table.swing(c);
            } while (c != start && n <= count[v]);
            if (n != count[v]) throw new MalformedStreamException(-1, "a vertex of the base has two fans");
        }
    }

    private static int next(int h) {
        return h % 3 == 2 ? h - 2 : h + 1;
    }

    private static int previous(int h) {
        return h % 3 == 0 ? h + 2 : h - 1;
    }
}
