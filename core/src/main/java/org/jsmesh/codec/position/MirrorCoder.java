package org.jsmesh.codec.position;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.lattice.Lattice;
import org.jsmesh.codec.lattice.LatticeCoder;
import org.jsmesh.codec.lattice.StepCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes positions of vertices whose mirror image is there already. It codes that a vertex is an image, and by how much
 * it is off along the mirror's axis.
 */
final class MirrorCoder {
    private static final int DISTANCES = 9;

    /**
     * Largest distance of a new vertex from where it is expected, in parts of its ring's spread. Beyond, it is hardly
     * ever the one whose image was found.
     */
    private static final double REACH = .9;

    private static final int MOST_OFF = 1; // in units
    private final LodMesh mesh;
    private final Lattice lattice;
    private final Mirror mirror;
    private final MirrorPairs pairs;
    private final UnpairedVertexGrid lonely;
    private final int[] sameInSweep = BinaryCoder.newContexts(2);
    private final int[] sameInPass = BinaryCoder.newContexts(3 * DISTANCES);
    private final IntegerModel off = new IntegerModel(1);
    private final StepCoder steps;
    private final LatticeCoder points;
    private int lastSame;
    private int shift;

    MirrorCoder(LodMesh mesh, Lattice lattice, Mirror mirror) {
        this.mesh = mesh;
        this.lattice = lattice;
        this.mirror = mirror;
        pairs = new MirrorPairs(mesh, lattice, mirror);
        lonely = new UnpairedVertexGrid(mesh);
        steps = new StepCoder(lattice, 1);
        points = new LatticeCoder(lattice);
    }

    /** Starts a sweep from units of 2^from cells to units of 2^to. */
    void beginSweep(int from, int to) {
        shift = to;
        pairs.begin(from);
    }

    /** Starts a pass that adds vertices in units of 2^shift cells. */
    void beginPass(int shift) {
        this.shift = shift;
        lonely.begin(pairs.all(shift));
    }

    /** The images of wedges, once positions are exact. */
    WedgeTwins twins() {
        return new WedgeTwins(mesh, mirror, pairs.all(0));
    }

    /**
     * Codes whether a vertex of a sweep is the image of one before it. If it is, codes its units; exact positions are
     * stored at once.
     *
     * @param wanted cells, for the encoder
     * @param bits of the wanted positions, from {@code at}, for the encoder
     * @param units receives the position
     */
    boolean codeInSweep(BinaryCoder coder, int vertex, int[] wanted, int[] bits, int at, int[] units)
            throws MalformedStreamException {
        if (!pairs.holds(vertex)) throw new MalformedStreamException(-1, "a sweep goes on that has not begun");
        int twin = pairs.find(vertex);
        if (twin < 0) return false;
        lastSame = coder.bit(sameInSweep, lastSame, coder.isEncoder() && isImage(twin, wanted, bits, at) ? 1 : 0);
        if (lastSame != 0) take(coder, vertex, twin, wanted, bits, at, units);
        return lastSame != 0;
    }

    /** Adds the vertex that the sweep has come to. */
    void addInSweep(int vertex) {
        pairs.add(vertex);
    }

    /**
     * Codes whether a new vertex is the image of an unpaired vertex: the one closest to the image of where the new
     * vertex is expected. Otherwise as {@link #codeInSweep}.
     */
    boolean codeInPass(BinaryCoder coder, int vertex, Ring ring, int[] wanted, int[] bits, int at, int[] units)
            throws MalformedStreamException {
        double[] x = ring.expected();
        x[mirror.axis()] = mirror.cell(PositionCoder.round(x[mirror.axis()]), lattice);
        double spread = ring.width;
        int twin = lonely.nearest(x[0], x[1], x[2], spread * REACH);
        if (twin < 0) return false;
        int known = 0;
        for (int i = 0; i < ring.size; i++) if (lonely.isPaired(mesh.vertexOf(ring.neighbour[i]))) known++;
        int distance = spread > 0 ? (int) (lonely.distance() / spread * 10) : 0;
        int context = Math.min(distance, DISTANCES - 1) * 3 + 2 * known / ring.size;
        if (coder.bit(sameInPass, context, coder.isEncoder() && isImage(twin, wanted, bits, at) ? 1 : 0) == 0)
            return false;
        take(coder, vertex, twin, wanted, bits, at, units);
        lonely.pair(twin);
        return true;
    }

    /** Adds a new vertex that has its position. */
    void addInPass(int vertex, boolean paired) {
        int cell = mesh.places()[4 * mesh.firstFan(vertex) + mirror.axis()];
        boolean isOwn = Math.abs((cell >> shift) - (mirror.cell(cell, lattice) >> shift)) <= 1;
        lonely.add(vertex, paired || isOwn);
    }

    /** Gives a vertex the position of the image, plus some coded steps along the axis. */
    private void take(BinaryCoder coder, int vertex, int twin, int[] wanted, int[] bits, int at, int[] units)
            throws MalformedStreamException {
        int[] cells = mesh.places();
        int[] known = mesh.positionBits();
        int other = 4 * mesh.firstFan(twin);
        int axis = mirror.axis();
        for (int a = 0; a < 3; a++) units[a] = cells[other + a] >> shift;
        if (shift > 0) {
            units[axis] = mirror.cell(cells[other + axis], lattice) >> shift;
            if (!mirror.isExact())
                units[axis] += off.signed(coder, 0, coder.isEncoder() ? (wanted[axis] >> shift) - units[axis] : 0);
            return;
        }
        for (int a = 0; a < 3; a++) known[3 * vertex + a] = known[3 * twin + a];
        int near = mirror.bits(known[3 * twin + axis], lattice);
        if (!steps.code(coder, 0, near, coder.isEncoder() ? bits[at + axis] : 0)
                || (steps.reached() & 0x7f800000) == 0x7f800000)
            throw new MalformedStreamException(-1, "a position is beyond its lattice");
        known[3 * vertex + axis] = steps.reached();
        units[axis] = points.cell(steps.reached());
    }

    /** Can a position be coded as an image? The encoder's side. */
    private boolean isImage(int twin, int[] wanted, int[] bits, int at) {
        int[] cells = mesh.places();
        int other = 4 * mesh.firstFan(twin);
        int axis = mirror.axis();
        for (int a = 0; a < 3; a++) {
            if (a == axis) continue;
            if (wanted[a] >> shift != cells[other + a] >> shift) return false;
            if (shift == 0 && bits[at + a] != mesh.positionBits()[3 * twin + a]) return false;
        }
        if (shift == 0)
            return steps.reaches(mirror.bits(mesh.positionBits()[3 * twin + axis], lattice), bits[at + axis]);
        int units = (wanted[axis] >> shift) - (mirror.cell(cells[other + axis], lattice) >> shift);
        return Math.abs(units) <= (mirror.isExact() ? 0 : MOST_OFF);
    }
}
