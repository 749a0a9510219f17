package org.jsmesh.codec;

import java.util.List;
import org.jsmesh.codec.attribute.AttributeSweep;
import org.jsmesh.codec.attribute.ByteRefiner;
import org.jsmesh.codec.attribute.ChannelCoder;
import org.jsmesh.codec.attribute.ChannelDetector;
import org.jsmesh.codec.attribute.ChannelFormat;
import org.jsmesh.codec.attribute.ChannelRefiner;
import org.jsmesh.codec.attribute.ChannelValues;
import org.jsmesh.codec.attribute.NormalRefiner;
import org.jsmesh.codec.attribute.StagedRefiner;
import org.jsmesh.codec.attribute.WedgeCoder;
import org.jsmesh.codec.connectivity.CodedMesh;
import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.EncoderTruth;
import org.jsmesh.codec.connectivity.PairRunner;
import org.jsmesh.codec.connectivity.SplitLane;
import org.jsmesh.codec.connectivity.StitchCoder;
import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.LodSurface;
import org.jsmesh.codec.lod.Renumbering;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.mesh.Channel;
import org.jsmesh.mesh.CornerTable;
import org.jsmesh.mesh.MalformedStreamException;
import org.jsmesh.mesh.Material;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.Picture;
import org.jsmesh.mesh.Texture;

/**
 * Codes a mesh in both directions: the base, then pass after pass of vertex splits. Connectivity, geometry and
 * attributes go through a coder each ({@link Streams}), so that a batch holds them one after the other; contexts live
 * as long as this object.
 */
public final class MeshCoder {
    /** New numbers cost about what 10% of the vertices do, and gain nothing in the first caches. */
    private static final double RENUMBER_GROWTH = 1.9;

    private static final int RENUMBER_FROM = 12_000;

    /** Fewer splits at a time are not worth the help of another thread. */
    private static final int WORTH_HELP = 512;

    /** Splits by which connectivity is ahead of positions at the least; a power of two. */
    private static final int LEAD = 64;

    private final MeshFormat format;
    private final LodMesh mesh;
    private final EncoderTruth truth;
    private final ConnectivityCoder connectivity;
    private final PositionCoder positions;
    private final WedgeCoder wedges;
    private int numbered; // vertices when they were last renumbered
    private final ChannelValues[] values;
    private final ChannelRefiner[] refiners;
    private AttributeSweep attributes; // when it has begun
    private int unit;
    private int unitBefore;
    private int refined;
    private boolean isSweeping;
    private int moved; // by the sweep: so many vertices, the first ones, are coded anew
    private final int[] moving = BinaryCoder.newContexts(1);
    private final SplitLane lane = new SplitLane();
    private PairRunner helper; // or null
    private final SplitSteps steps; // encoder only
    private final ComponentCoder components;
    private int mostFaces; // at the end of the batch

    /** The coders of a batch's three parts. */
    public record Streams(BinaryCoder connectivity, BinaryCoder geometry, BinaryCoder attributes) {
        public boolean isExhausted() {
            return connectivity.isExhausted() || geometry.isExhausted() || attributes.isExhausted();
        }
    }

    private MeshCoder(MeshFormat format, CodedMesh source, int vertices, int faces) {
        this.format = format;
        mesh = new LodMesh(!format.channels.isEmpty(), format.materials > 0, format.hasStitches, vertices, faces);
        truth = source == null ? null : new EncoderTruth(source, mesh);
        connectivity = new ConnectivityCoder(mesh, lane, format.hasStitches ? new StitchCoder(mesh, truth) : null);
        steps = source == null ? null : new SplitSteps(mesh);
        positions = new PositionCoder(
                mesh,
                format.positions,
                format.mirror,
                source == null ? null : format.codedPositions(source.original()));
        int n = format.channels.size();
        ChannelCoder[] channels = new ChannelCoder[n];
        values = new ChannelValues[n];
        refiners = new ChannelRefiner[n];
        for (int i = 0; i < n; i++) {
            ChannelFormat channel = format.channels.get(i);
            Channel original = source == null
                    ? null
                    : ChannelDetector.coded(
                            channel, source.original().channels().get(i));
            values[i] = new ChannelValues(channel);
            channels[i] = new ChannelCoder(values[i], original);
            if (channel.normals() != null) refiners[i] = new NormalRefiner(values[i], original);
            else if (channel.lattice() == null && channel.isRefined())
                refiners[i] = new ByteRefiner(values[i], original);
            else if (channel.isRefined()) refiners[i] = new StagedRefiner(values[i], original);
        }
        wedges = new WedgeCoder(mesh, channels, format.materials, truth);
        components = new ComponentCoder(mesh, format, truth, connectivity, positions, wedges, steps);
        mostFaces = faces;
    }

    /** A decoder of a mesh that is claimed to have so many vertices and faces in the end. */
    public static MeshCoder decoder(MeshFormat format, int vertices, int faces) {
        return new MeshCoder(format, null, vertices, faces);
    }

    public static MeshCoder encoder(MeshFormat format, CodedMesh source) {
        return new MeshCoder(
                format, source, source.original().vertices(), source.original().faces());
    }

    /** Has an encoder code connectivity and positions at the same time. The bytes are the same. */
    public void useHelper(PairRunner beside) {
        if (format.mirror.isNone()) helper = beside;
    }

    /** Positions from the base on are coded in units of 2^shift cells; 0: exactly. */
    public void setPrecision(int shift) {
        unit = shift;
        positions.setShift(shift);
    }

    /** The precision of new positions, see {@link #setPrecision}. */
    public int precision() {
        return unit;
    }

    /**
     * Codes positions that a fit has moved, from the base or the next sweep on.
     *
     * @param cells by which the vertices of the original are moved, three for each; null brings them back
     */
    public void move(int[] cells) {
        positions.move(cells);
        if (mesh.vertices() == 0) positions.haveMoved();
    }

    /** Begins to bring all vertices, and those to come, to a higher precision. */
    public void beginSweep(int shift) {
        unitBefore = unit;
        setPrecision(shift);
        positions.beginSweep(unitBefore);
        refined = 0;
        isSweeping = true;
    }

    /** Codes the positions of the sweep's next vertices. */
    public void codeSweep(BinaryCoder stream, int count) throws MalformedStreamException {
        if (refined == 0) moved = codeMoved(stream);
        for (int i = 0; i < count; i++, refined++) {
            if ((i & 15) == 0 && stream.isExhausted()) return;
            int original = truth == null ? -1 : positions.isMoved() ? truth.originalOf(refined) : 0;
            if (refined < moved) positions.move(stream, refined, unitBefore, original);
            else positions.refine(stream, refined, unitBefore, original);
        }
        if (refined < mesh.vertices()) return;
        isSweeping = false;
        positions.haveMoved();
    }

    /**
     * Codes how many vertices the sweep moves, instead of making their positions more precise: those up to the last one
     * that a fit moves.
     */
    private int codeMoved(BinaryCoder stream) {
        int count = 0;
        if (positions.isMoving()) {
            count = mesh.vertices();
            while (count > 0 && !positions.isMoving(truth.originalOf(count - 1))) count--;
        }
        if (stream.bit(moving, 0, count > 0 ? 1 : 0) == 0) return 0;
        return 1 + stream.uniform(count - 1, mesh.vertices());
    }

    /** Vertices that the sweep has still to come to. */
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
     * Wedges whose attributes can be made exact before anything else is, but are not: 8-bit values at any precision of
     * the positions, others when these are exact.
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

    /** True when batches have an attribute part. */
    public boolean hasAttributes() {
        return mesh.hasChannels || mesh.hasMaterials;
    }

    /** Faces shown now. */
    public int faces() {
        return mesh.realFaces();
    }

    /** Vertices shown now. */
    public int vertices() {
        return mesh.vertices();
    }

    /**
     * Codes the base.
     *
     * @param knownFaces that it has, and vertices: of use to a decoder
     */
    public void codeBase(Streams streams, int knownFaces, int knownVertices) throws MalformedStreamException {
        components.codeBase(streams, knownFaces, knownVertices);
    }

    /** The mesh has no more faces than this before the next call. A decoder believes no more. */
    public void expectFaces(int most) {
        mostFaces = most;
    }

    /** Starts the next pass; the encoder names its number in the log. */
    public void beginPass(int logPass) {
        boolean mayRenumber = !format.hasStitches && connectivity.hasBegun() && mesh.fans() >= RENUMBER_FROM;
        if (mayRenumber && mesh.fans() > RENUMBER_GROWTH * numbered) renumber();
        if (helper == null || mesh.fans() < WORTH_HELP) {
            beginConnectivity(logPass);
            positions.beginPass();
        } else {
            helper.runBoth(() -> beginConnectivity(logPass), positions::beginPass);
        }
    }

    private void beginConnectivity(int logPass) {
        components.beginPass(logPass);
        connectivity.beginPass();
        if (truth != null) truth.plan.loadPass(logPass, mesh.fans());
    }

    /**
     * Codes and applies the next steps of a pass: components, then vertex splits. Of these, all connectivity comes
     * first, then all positions, which is the same as one after the other, because the faces around a new vertex change
     * no more in its pass, and what surrounds a vertex that splits has positions from before the pass. A decoder stops
     * early when its streams end.
     */
    public void codeSplits(Streams streams, int number) throws MalformedStreamException {
        int count = number;
        for (; count > 0 && components.codeAnother(streams, mostFaces - mesh.realFaces()); count--)
            if (streams.isExhausted()) return;
        if (count > 0) codeMoreSplits(streams, count);
    }

    private void codeMoreSplits(Streams streams, int count) throws MalformedStreamException {
        int first = mesh.fans();
        lane.begin(count);
        if (helper != null && count >= WORTH_HELP) {
            mesh.reservePositions(count);
            helper.runBoth(() -> connect(streams, count), () -> place(streams, first, count));
            return;
        }
        codeConnectivity(streams, count);
        if (truth != null) find(first, 0, count);
        for (int i = 0; i < lane.splits(); i++) {
            if ((i & 15) == 0 && streams.isExhausted()) return;
            codePosition(streams, first, i);
        }
    }

    private void codeConnectivity(Streams streams, int count) throws MalformedStreamException {
        for (int i = 0; i < count; i++) {
            if ((i & 15) == 0 && streams.isExhausted()) return;
            int u = connectivity.codeSplit(streams.connectivity, truth == null ? null : truth.plan);
            if (hasAttributes())
                wedges.codeSplit(
                        streams.attributes, u, lane.parent(i), mesh.table().faces() - 2, connectivity.patch());
            if (helper != null && (i & LEAD - 1) == LEAD - 1) lane.publish();
        }
    }

    private void codePosition(Streams streams, int first, int split) throws MalformedStreamException {
        int fan = first + split;
        int vertex = mesh.vertexOf(fan);
        if (mesh.firstFan(vertex) != fan) {
            positions.copy(fan, vertex);
        } else {
            codeNewPosition(streams, fan, split);
        }
        if (steps != null) steps.add(fan, lane.rings(), lane.ringStart(split), lane.ringEnd(split));
    }

    private void codeNewPosition(Streams streams, int fan, int split) throws MalformedStreamException {
        int original = truth == null ? -1 : positions.isMoved() ? truth.originalVertex(fan) : 0;
        positions.codeFromRing(
                streams.geometry,
                fan,
                lane.rings(),
                lane.ringStart(split),
                lane.ringEnd(split),
                lane.parent(split),
                original);
    }

    /** The encoder looks up some positions at once, so that memory answers many questions at a time. */
    private void find(int first, int from, int to) {
        for (int fan = first + from; fan < first + to; fan++)
            positions.find(mesh.vertexOf(fan), truth.originalVertex(fan));
    }

    private void connect(Streams streams, int count) {
        try {
            codeConnectivity(streams, count);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own values are in range
        } finally {
            lane.close();
        }
    }

    /** Codes positions as soon as connectivity has made the vertices. */
    private void place(Streams streams, int first, int count) {
        try {
            for (int from = 0; from < count; from += LEAD) {
                int to = Math.min(count, from + LEAD);
                if (!lane.await(to - 1, helper)) return; // the other half has failed and says why
                find(first, from, to);
                for (int i = from; i < to; i++) codePosition(streams, first, i);
            }
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e);
        }
    }

    private void renumber() {
        Renumbering numbers = connectivity.renumbering();
        mesh.renumber(numbers);
        connectivity.renumber(numbers);
        positions.renumber(numbers);
        if (truth != null) truth.plan.renumber(numbers);
        numbered = mesh.fans();
    }

    /**
     * The surface of the encoder as it would be shown if the positions were exact; with the vertices of the original.
     */
    public LodSurface exactSurface(Mesh original) {
        CornerTable t = mesh.table();
        int[] corners = new int[3 * mesh.realFaces()];
        int n = 0;
        for (int f = 0; f < t.faces(); f++) {
            if (t.isDummy(f)) continue;
            for (int j = 0; j < 3; j++) corners[n++] = truth.originalVertex(t.vertex(CornerTable.STRIDE * f + j));
        }
        return new LodSurface(original.positions(), corners);
    }

    /** The surface as it is shown now. */
    public LodSurface surface() {
        return LodSurface.shown(mesh, format.cellSize(), format.translation, exactVertices());
    }

    /** A coordinate of a vertex of the {@link #surface} as it is shown now. */
    public double coordinate(int vertex, int axis) {
        if (vertex < exactVertices())
            return Float.intBitsToFloat(format.translation.moved(axis, mesh.positionBits()[3 * vertex + axis]));
        int cell = mesh.places()[4 * mesh.firstFan(vertex) + axis];
        return format.cellSize() * cell + format.translation.offset(axis);
    }

    /** Vertices, from the first one on, whose positions are exact. */
    private int exactVertices() {
        return unit > 0 ? 0 : isSweeping ? refined : mesh.vertices();
    }

    /**
     * How far the splits since the last call have moved the surface, at most, at their vertices; in cells, as it is
     * shown.
     */
    public double largestStep() {
        double largest = steps.largest();
        steps.forget();
        return largest;
    }

    /** The mesh as it is shown now. */
    public Mesh snapshot(List<Material> materials, List<Texture> textures, List<Picture> previews) {
        if (unit > 0) positions.show(0);
        else if (isSweeping) positions.show(refined);
        return LodSnapshot.of(mesh, format.translation, values)
                .materials(materials)
                .textures(textures)
                .previews(previews)
                .build();
    }
}
