package org.jsmesh.codec.position;

import org.jsmesh.codec.connectivity.SplitLane;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.ResidualCoder;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.VertexNormals;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes the position of a new vertex. Its cells are coded as differences from the mean of its ring; the last one is
 * along the axis closest to the ring's normal and corrected by the ring's plane or a smooth surface. Then its points on
 * the lattice follow. Until positions are exact, they are coded in units of 2<sup>shift</sup> cells and shown at the
 * middle of their unit.
 */
public final class PositionCoder {
    private static final int FIRST_TANGENT = 0;
    private static final int SECOND_TANGENT = 1;
    private static final int NORMAL = 2;
    private static final int FREE = 3; // without a prediction from a ring
    private static final int MOVED = 4; // from where a fit had put it
    private static final int FRACTION_BITS = 2; // of expected sizes
    private static final int SECOND_TAG =
            16; // tags: twice the class of the tangents' surprise, and above that of the normal's
    private static final int UNTAGGED = 2 * ResidualCoder.NO_SURPRISE * ((1 << SECOND_TAG) + 1);
    private static final int UNIT = 2 * FRACTION_BITS; // scale class of one unit
    private final LodMesh mesh;
    private final Lattice lattice;
    private final LatticeCoder[] points = new LatticeCoder[3];
    private final ResidualCoder residuals = new ResidualCoder(5, UNIT);
    private final Ring ring;
    private final PositionRefiner refiner;
    private final MirrorCoder mirrored; // null where there is no mirror
    private final PositionTruth truth;
    private final int[] wanted; // the truth's answer
    private final int[] cell = new int[3];
    private final VertexNormals normals;
    private final TangentPredictor tangents;
    private final HeightPredictor heights;
    private int shift;
    private int tangentSurprise;
    private int normalSurprise;
    private int residualSurprise;

    /**
     * @param dense whether the predictors are those that take more time
     * @param originals the original's positions for the encoder, else null
     */
    public PositionCoder(LodMesh mesh, Lattice lattice, Mirror mirror, boolean dense, float[] originals) {
        this.mesh = mesh;
        this.lattice = lattice;
        ring = new Ring(mesh);
        normals = new VertexNormals(mesh);
        tangents = new TangentPredictor(mesh, ring, dense);
        heights = new HeightPredictor(ring);
        refiner = new PositionRefiner(mesh, ring);
        mirrored = mirror.isNone() ? null : new MirrorCoder(mesh, lattice, mirror);
        for (int a = 0; a < 3; a++) points[a] = new LatticeCoder(lattice);
        truth = new PositionTruth(mesh, lattice, points, originals);
        wanted = truth.wanted;
    }

    /** Sets the unit of positions to come to 2^shift cells; 0: exact positions. */
    public void setShift(int cells) {
        shift = cells;
    }

    /** Are positions to come exact? */
    public boolean isExact() {
        return shift == 0;
    }

    /** The mirror images of wedges, once positions are exact; null where there is no mirror. */
    public WedgeTwins twins() {
        return mirrored == null ? null : mirrored.twins();
    }

    /** What an encoder is to code. */
    public PositionTruth truth() {
        return truth;
    }

    /**
     * Starts a pass: new vertices are predicted from the mesh as it is now.
     *
     * @param splits whether splits may come
     */
    public void beginPass(boolean splits) {
        if (splits) normals.compute();
        if (mirrored != null) mirrored.beginPass(shift);
    }

    /** Starts to refine the known positions to the units that are now set. */
    public void beginSweep(int from) {
        refiner.begin();
        if (mirrored != null) mirrored.beginSweep(from, shift);
    }

    /** Codes the position of fan vertex u, the only fan of its vertex, from the ring of a split. */
    public void codeFromRing(BinaryCoder coder, int u, SplitLane lane, int split, int original)
            throws MalformedStreamException {
        int from = lane.ringStart(split);
        int v = lane.parent(split);
        truth.want(mesh.vertexOf(u), original);
        ring.measure(lane.rings(), from, lane.ringEnd(split));
        if (codeImage(coder, u, original)) return;
        meetNeighbours();
        double unit = 1 << shift;
        tangents.begin(lane.beyond(), SplitLane.FEW * split, unit);
        int p = codeTangent(coder, FIRST_TANGENT, ring.first, tangents.first(), v);
        int sum = residualSurprise;
        tangents.learnFirst(p);
        int q = codeTangent(coder, SECOND_TANGENT, ring.second, tangents.second(), v);
        sum += residualSurprise;
        tangents.learnSecond(q);
        double z = heights.predict(normals.values(), p, q, unit);
        int lean = (int) (7 * fraction(z / unit)) - 3;
        heights.learn(codeCell(coder, NORMAL, ring.normalAxis, round(z), size(heights.size()), lean));
        mesh.places()[4 * u + 3] = sum | residualSurprise << SECOND_TAG + 1;
        store(coder, u, original, ring.size);
        if (mirrored != null) mirrored.addInPass(mesh.vertexOf(u), false);
    }

    private int codeTangent(BinaryCoder coder, int role, int axis, double cells, int v)
            throws MalformedStreamException {
        int predicted = round(cells);
        int size = size(tangents.size(axis));
        return codeCell(coder, role, axis, predicted, size, lean(mesh.places()[4 * v + axis] - predicted, size));
    }

    private static int size(double expected) {
        return (int) Math.min(1 << 28, expected);
    }

    /** The part of a number above the next integer below. */
    private static double fraction(double x) {
        int whole = (int) x;
        return Math.min(.999, x < whole ? x - whole + 1 : x - whole);
    }

    /** Codes whether a new vertex is the mirror image of one that is there. */
    private boolean codeImage(BinaryCoder coder, int u, int original) throws MalformedStreamException {
        int vertex = mesh.vertexOf(u);
        if (mirrored == null || ring.size == 0) return false;
        if (!mirrored.codeInPass(coder, vertex, ring, wanted, truth.bits(), 3 * vertex, cell)) return false;
        storeImage(u);
        mesh.places()[4 * u + 3] = UNTAGGED;
        mirrored.addInPass(vertex, true);
        return true;
    }

    /** Stores the units of an image; exact positions are stored already. */
    private void storeImage(int fan) throws MalformedStreamException {
        for (int a = 0; a < 3; a++) {
            cell[a] = middle(cell[a]);
            mesh.places()[4 * fan + a] = cell[a];
        }
    }

    /** Averages how well the neighbours were predicted. */
    private void meetNeighbours() {
        tangentSurprise = (ring.tagSum & (1 << SECOND_TAG) - 1) / (2 * ring.size);
        normalSurprise = (ring.tagSum >> SECOND_TAG) / (2 * ring.size);
    }

    /** Codes the position of a vertex near a prediction in cells. */
    public void codeNear(BinaryCoder coder, int fan, double x, double y, double z, int expectedSize, int original)
            throws MalformedStreamException {
        if (original >= 0) truth.find(mesh.vertexOf(fan), original);
        truth.want(mesh.vertexOf(fan), original);
        int scale = scale(expectedSize);
        for (int a = 0; a < 3; a++) {
            int predicted = round(a == 0 ? x : a == 1 ? y : z) >> shift;
            int residual =
                    residuals.code(coder, FREE, scale, ResidualCoder.NO_SURPRISE, 0, (wanted[a] >> shift) - predicted);
            cell[a] = middle(predicted + residual);
        }
        store(coder, fan, original, 0);
        mesh.places()[4 * fan + 3] = UNTAGGED;
    }

    /** Codes more bits of the position of a vertex that is known in units of 2^from cells. */
    public void refine(BinaryCoder coder, int vertex, int from, int original) throws MalformedStreamException {
        truth.want(vertex, original);
        int fan = mesh.firstFan(vertex);
        if (mirrored != null && mirrored.codeInSweep(coder, vertex, wanted, truth.bits(), 3 * vertex, cell)) {
            storeImage(fan);
        } else {
            int known = refiner.code(coder, vertex, from, shift, wanted, cell);
            for (int a = 0; a < 3; a++) cell[a] = middle(cell[a]);
            store(coder, fan, original, known);
        }
        if (mirrored != null) mirrored.addInSweep(vertex);
        copyToOthers(fan, vertex);
    }

    /** Codes the position of a vertex again that was shown elsewhere, within units of 2^from cells. */
    public void move(BinaryCoder coder, int vertex, int from, int original) throws MalformedStreamException {
        truth.want(vertex, original);
        int fan = mesh.firstFan(vertex);
        if (mirrored != null && mirrored.codeInSweep(coder, vertex, wanted, truth.bits(), 3 * vertex, cell)) {
            storeImage(fan);
        } else {
            int scale = scale(1 << from);
            for (int a = 0; a < 3; a++) {
                int predicted = mesh.places()[4 * fan + a] >> shift;
                int residual = residuals.code(
                        coder, MOVED, scale, ResidualCoder.NO_SURPRISE, 0, (wanted[a] >> shift) - predicted);
                cell[a] = middle(predicted + residual);
            }
            store(coder, fan, original, 0);
        }
        if (mirrored != null) mirrored.addInSweep(vertex);
        copyToOthers(fan, vertex);
    }

    private void copyToOthers(int fan, int vertex) {
        for (int other = mesh.nextFan(fan); other != 0; other = mesh.nextFan(other)) copy(other, vertex);
    }

    /** Gives a further fan of a vertex the cells of an earlier one. */
    public void copy(int fan, int vertex) {
        int other = mesh.firstFan(vertex);
        System.arraycopy(mesh.places(), 4 * other, mesh.places(), 4 * fan, 4);
    }

    /** Stores the shown positions of the vertices from a number on; these are not exact. */
    public void show(int first) {
        int[] bits = mesh.positionBits();
        int[] cells = mesh.places();
        for (int v = first; v < mesh.vertices(); v++) {
            int at = 4 * mesh.firstFan(v);
            for (int a = 0; a < 3; a++) bits[3 * v + a] = lattice.shownBits(cells[at + a]);
        }
    }

    /** A coordinate of a vertex that is not exact, as it is shown. */
    public int shownBits(int vertex, int axis) {
        return lattice.shownBits(mesh.places()[4 * mesh.firstFan(vertex) + axis]);
    }

    private int codeCell(BinaryCoder coder, int role, int axis, int predictedCell, int size, int lean)
            throws MalformedStreamException {
        int predicted = predictedCell >> shift;
        int scale = scale(size);
        int surprise = role == NORMAL ? normalSurprise : tangentSurprise;
        int residual = residuals.code(coder, role, scale, surprise, lean, (wanted[axis] >> shift) - predicted);
        residualSurprise = residuals.surprise(scale, UNIT);
        cell[axis] = middle(predicted + residual);
        return cell[axis];
    }

    private static int lean(int difference, int size) {
        int magnitude = difference < 0 ? -difference : difference;
        int lean = magnitude == 0 ? 0 : magnitude <= size >> 1 ? 1 : magnitude <= size ? 2 : 3;
        return difference < 0 ? -lean : lean;
    }

    private int scale(int size) {
        int excess = shift - FRACTION_BITS;
        return ResidualCoder.scale(excess > 0 ? size >> excess : size << -excess);
    }

    /** The cell in the middle of a unit. */
    private int middle(int unit) throws MalformedStreamException {
        int limit = lattice.cellLimit();
        int low = unit << shift;
        if (low >> shift != unit || low >= limit || low + (1 << shift) <= -limit)
            throw new MalformedStreamException(-1, "a position is outside its lattice");
        return shift == 0 ? unit : low + (1 << shift - 1);
    }

    static int round(double x) {
        return (int) (x < 0 ? x - .5 : x + .5);
    }

    /**
     * Codes the exact values in the cells. One of the first {@code neighbours} ring vertices predicts the value if it
     * lies in the same cell.
     */
    private void store(BinaryCoder coder, int fan, int original, int neighbours) throws MalformedStreamException {
        int vertex = mesh.vertexOf(fan);
        int[] cells = mesh.places();
        int[] bits = mesh.positionBits();
        for (int a = 0; a < 3; a++) {
            cells[4 * fan + a] = cell[a];
            if (shift > 0) continue;
            int near = 0;
            while (near < neighbours && cells[4 * ring.neighbour[near] + a] != cell[a]) near++;
            boolean found = near < neighbours;
            int neighbourBits = found ? bits[3 * mesh.vertexOf(ring.neighbour[near]) + a] : 0;
            int wantedBits = original < 0 ? 0 : truth.bits()[3 * vertex + a];
            bits[3 * vertex + a] = points[a].code(coder, cell[a], wantedBits, found, neighbourBits);
        }
    }
}
