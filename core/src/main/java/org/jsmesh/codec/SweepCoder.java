package org.jsmesh.codec;

import org.jsmesh.codec.attribute.AttributeSweep;
import org.jsmesh.codec.attribute.ByteRefiner;
import org.jsmesh.codec.attribute.ChannelRefiner;
import org.jsmesh.codec.attribute.ChannelValues;
import org.jsmesh.codec.connectivity.EncoderTruth;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.mesh.MalformedStreamException;

/**
 * Codes sweeps over the present mesh: more bits of all positions, vertices that move, and exact attributes of all
 * wedges. Keeps the precision of positions, which splits use too.
 */
public final class SweepCoder {
    private final LodMesh mesh;
    private final MeshFormat format;
    private final EncoderTruth truth; // encoder only
    private final PositionCoder positions;
    private final ChannelValues[] values;
    private final ChannelRefiner[] refiners; // null where values come exact with their wedge, or are already exact
    private AttributeSweep attributes; // when it has begun
    private int unit;
    private int unitBefore;
    private int refined;
    private boolean isSweeping;
    private int moved; // number of vertices, from the first one on, that the sweep codes anew
    private final int[] moving = BinaryCoder.newContexts(1);
    private final int[] keeping = BinaryCoder.newContexts(1); // sweeps that keep the shift

    SweepCoder(
            LodMesh mesh,
            MeshFormat format,
            EncoderTruth truth,
            PositionCoder positions,
            ChannelValues[] values,
            ChannelRefiner[] refiners) {
        this.mesh = mesh;
        this.format = format;
        this.truth = truth;
        this.positions = positions;
        this.values = values;
        this.refiners = refiners;
    }

    /** Sets the unit of positions to come to 2^shift cells; 0: exact positions. */
    public void setPrecision(int shift) {
        unit = shift;
        positions.setShift(shift);
    }

    /** The precision of new positions, see {@link #setPrecision}. */
    public int precision() {
        return unit;
    }

    /**
     * Sets the moves of a fit, which count from the base or the next sweep on.
     *
     * @param cells by which the vertices of the original move, three for each; null brings them back
     */
    public void move(int[] cells) {
        positions.truth().move(cells);
        if (mesh.vertices() == 0) positions.truth().haveMoved();
    }

    /**
     * Codes the sweep before a pass, if there is one: where the shift falls, or where a bit says that vertices move.
     *
     * @param drop by how many bits the shift falls
     * @param sweeps whether there is one, for an encoder
     */
    public void codeBeforePass(BinaryCoder stream, int drop, boolean sweeps) throws MalformedStreamException {
        if (drop == 0 && (unit == 0 || stream.bit(keeping, 0, sweeps ? 1 : 0) == 0)) return;
        begin(unit - drop);
        code(stream, mesh.vertices());
    }

    /** Is there a sweep of which vertices are left? */
    public boolean isSweeping() {
        return isSweeping;
    }

    /** Whether a vertex that is there moves. If none does, the moves of a fit count from now on. */
    public boolean movesAny() {
        if (countMoved() > 0) return true;
        positions.truth().haveMoved();
        return false;
    }

    /** Begins to bring all vertices, and those to come, to a precision, which is higher unless vertices move. */
    public void begin(int shift) {
        unitBefore = unit;
        setPrecision(shift);
        positions.beginSweep(unitBefore);
        refined = 0;
        isSweeping = true;
    }

    /** Codes the positions of the sweep's next vertices. */
    public void code(BinaryCoder stream, int count) throws MalformedStreamException {
        if (refined == 0) moved = codeMoved(stream);
        if (mesh.changes() != null) mesh.changes().move(refined, Math.min(refined + count, mesh.vertices()));
        for (int i = 0; i < count; i++, refined++) {
            if ((i & 15) == 0 && stream.isExhausted()) return;
            int original = truth == null ? -1 : positions.truth().isMoved() ? truth.originalOf(refined) : 0;
            if (refined < moved) positions.move(stream, refined, unitBefore, original);
            else positions.refine(stream, refined, unitBefore, original);
        }
        if (refined < mesh.vertices()) return;
        isSweeping = false;
        positions.truth().haveMoved();
    }

    /** Codes how many vertices the sweep moves instead of refining them: those up to the last one that a fit moves. */
    private int codeMoved(BinaryCoder stream) {
        int count = countMoved();
        if (stream.bit(moving, 0, count > 0 ? 1 : 0) == 0) return 0;
        return 1 + stream.uniform(count - 1, mesh.vertices());
    }

    /** Vertices up to the last one that a fit moves. */
    private int countMoved() {
        if (!positions.truth().isMoving()) return 0;
        int count = mesh.vertices();
        while (count > 0 && !positions.truth().isMoving(truth.originalOf(count - 1))) count--;
        return count;
    }

    /** Vertices that the sweep has not reached yet. */
    public int unrefined() {
        return mesh.vertices() - refined;
    }

    /** Codes exact attributes of the next wedges, see {@link #coarseWedges}; no split follows. */
    public void codeAttributes(BinaryCoder stream, int count) throws MalformedStreamException {
        if (attributes == null) {
            if (unit > 0) positions.show(0);
            attributes = new AttributeSweep(mesh, format.translation, positions.twins(), values, nextRefiners(), truth);
        }
        attributes.code(stream, count);
        if (attributes.left() > 0) return;
        ChannelRefiner[] done = nextRefiners();
        for (int i = 0; i < done.length; i++) if (done[i] != null) refiners[i] = null;
        attributes = null;
    }

    /**
     * Wedges with attributes that can become exact now and are not yet: 8-bit values at any precision of the positions,
     * other values once positions are exact.
     */
    public int coarseWedges() {
        if (attributes != null) return attributes.left();
        for (ChannelRefiner r : nextRefiners()) if (r != null) return mesh.wedges();
        return 0;
    }

    /** True while attributes of some wedges are exact and those of others are not. */
    public boolean isAmidAttributes() {
        return attributes != null;
    }

    private ChannelRefiner[] nextRefiners() {
        ChannelRefiner[] next = refiners.clone();
        for (int i = 0; i < next.length && unit > 0; i++) if (!(next[i] instanceof ByteRefiner)) next[i] = null;
        return next;
    }

    /** Vertices, from the first one on, whose positions are exact. */
    int exactVertices() {
        return unit > 0 ? 0 : isSweeping ? refined : mesh.vertices();
    }

    /** A coordinate of a vertex as it is shown, in raw float32 bits. */
    int shownBits(int vertex, int axis) {
        return vertex < exactVertices() ? mesh.positionBits()[3 * vertex + axis] : positions.shownBits(vertex, axis);
    }

    /** Stores the shown positions of the vertices whose positions are not exact. */
    void show() {
        int exact = exactVertices();
        if (exact < mesh.vertices()) positions.show(exact);
    }
}
