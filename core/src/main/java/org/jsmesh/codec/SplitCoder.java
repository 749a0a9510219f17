package org.jsmesh.codec;

import org.jsmesh.codec.attribute.WedgeCoder;
import org.jsmesh.codec.connectivity.ConnectivityCoder;
import org.jsmesh.codec.connectivity.EncoderTruth;
import org.jsmesh.codec.connectivity.PairRunner;
import org.jsmesh.codec.connectivity.SplitLane;
import org.jsmesh.codec.connectivity.StitchCoder;
import org.jsmesh.codec.entropy.BatchStreams;
import org.jsmesh.codec.lod.LodMesh;
import org.jsmesh.codec.lod.Renumbering;
import org.jsmesh.codec.position.PositionCoder;
import org.jsmesh.mesh.MalformedStreamException;

/** Codes passes: components that come, then vertex splits with their connectivity, positions and wedges. */
final class SplitCoder {
    /**
     * Giving new numbers costs about as much as 10% of the vertices, and gains nothing while the mesh fits into the
     * first caches.
     */
    private static final double RENUMBER_GROWTH = 1.9;

    private static final int RENUMBER_FROM = 8_000;

    /** Fewer splits at a time are not worth the help of another thread. */
    private static final int WORTH_HELP = 512;

    /** Least number of splits by which connectivity is ahead of positions; a power of two. */
    private static final int LEAD = 64;

    private final LodMesh mesh;
    private final MeshFormat format;
    private final EncoderTruth truth; // encoder only
    private final ConnectivityCoder connectivity;
    private final PositionCoder positions;
    private final WedgeCoder wedges;
    private final SplitSteps steps; // encoder only
    private final ComponentCoder components;
    private final SplitLane lane;
    private PairRunner helper; // or null
    private int numbered; // fan vertices when they were last renumbered
    private int mostFaces; // at the end of the batch

    /** @param faces that the header claims for the whole mesh */
    SplitCoder(
            LodMesh mesh,
            MeshFormat format,
            EncoderTruth truth,
            PositionCoder positions,
            WedgeCoder wedges,
            SplitSteps steps,
            int faces) {
        this.mesh = mesh;
        this.format = format;
        this.truth = truth;
        this.positions = positions;
        this.wedges = wedges;
        this.steps = steps;
        mostFaces = faces;
        lane = new SplitLane(format.isDense);
        connectivity = new ConnectivityCoder(mesh, lane, format.hasStitches ? new StitchCoder(mesh, truth) : null);
        components = new ComponentCoder(mesh, format, truth, connectivity, positions, wedges, steps);
    }

    /** Has an encoder code connectivity and positions at the same time. The bytes are the same. */
    void useHelper(PairRunner beside) {
        if (format.mirror.isNone()) helper = beside;
    }

    /**
     * Codes the base.
     *
     * @param knownFaces faces of the base; these and the vertices are of use to a decoder
     */
    void codeBase(BatchStreams streams, int knownFaces, int knownVertices) throws MalformedStreamException {
        components.codeBase(streams, knownFaces, knownVertices);
    }

    /** The mesh has no more faces than this before the next call. A decoder believes no more. */
    void expectFaces(int most) {
        mostFaces = most;
    }

    /** Starts the next pass; the encoder names its number in the log. */
    void beginPass(int logPass) {
        boolean mayRenumber = !format.hasStitches && connectivity.hasBegun() && mesh.fans() >= RENUMBER_FROM;
        boolean splits = truth == null || truth.hasSplits(logPass);
        if (mayRenumber && mesh.fans() > RENUMBER_GROWTH * numbered) renumber();
        if (helper == null || mesh.fans() < WORTH_HELP) {
            beginConnectivity(logPass);
            positions.beginPass(splits);
        } else {
            helper.runBoth(() -> beginConnectivity(logPass), () -> positions.beginPass(splits));
        }
    }

    private void beginConnectivity(int logPass) {
        components.beginPass(logPass);
        if (!mesh.isSeparate()) connectivity.beginPass();
        if (truth != null) truth.plan.loadPass(logPass, mesh.fans());
    }

    /**
     * Codes and applies the next steps of a pass: components, then vertex splits. All connectivity of the splits comes
     * first, then all positions. This gives the same as split after split, because the faces around a new vertex change
     * no more in its pass, and the neighbours of a vertex that splits have positions from before the pass. A decoder
     * stops early when its streams end.
     */
    void code(BatchStreams streams, int number) throws MalformedStreamException {
        int count = number;
        for (; count > 0 && components.codeAnother(streams, mostFaces - mesh.realFaces()); count--)
            if (streams.isExhausted()) return;
        if (count > 0) codeMoreSplits(streams, count);
    }

    private void codeMoreSplits(BatchStreams streams, int count) throws MalformedStreamException {
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

    private void codeConnectivity(BatchStreams streams, int count) throws MalformedStreamException {
        for (int i = 0; i < count; i++) {
            if ((i & 15) == 0 && streams.isExhausted()) return;
            int u = connectivity.codeSplit(streams.connectivity(), truth == null ? null : truth.plan);
            mesh.noteSplit(u, lane.parent(i));
            if (mesh.hasChannels || mesh.hasMaterials)
                wedges.codeSplit(
                        streams.attributes(), u, lane.parent(i), mesh.table().faces() - 2, connectivity.patch());
            if (helper != null && (i & LEAD - 1) == LEAD - 1) lane.publish();
        }
    }

    private void codePosition(BatchStreams streams, int first, int split) throws MalformedStreamException {
        int fan = first + split;
        int vertex = mesh.vertexOf(fan);
        if (mesh.firstFan(vertex) != fan) {
            positions.copy(fan, vertex);
        } else {
            codeNewPosition(streams, fan, split);
        }
        if (steps != null) steps.add(fan, lane.rings(), lane.ringStart(split), lane.ringEnd(split));
    }

    private void codeNewPosition(BatchStreams streams, int fan, int split) throws MalformedStreamException {
        int original = truth == null ? -1 : positions.truth().isMoved() ? truth.originalVertex(fan) : 0;
        positions.codeFromRing(streams.geometry(), fan, lane, split, original);
    }

    /** Looks up some positions of the encoder at once, so that memory loads many of them at a time. */
    private void find(int first, int from, int to) {
        for (int fan = first + from; fan < first + to; fan++)
            positions.truth().find(mesh.vertexOf(fan), truth.originalVertex(fan));
    }

    private void connect(BatchStreams streams, int count) {
        try {
            codeConnectivity(streams, count);
        } catch (MalformedStreamException e) {
            throw new IllegalStateException(e); // the encoder's own values are in range
        } finally {
            lane.close();
        }
    }

    /** Codes positions as soon as connectivity has made the vertices. */
    private void place(BatchStreams streams, int first, int count) {
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
        mesh.renumber(numbers, positions.isExact());
        connectivity.renumber(numbers);
        positions.truth().renumber(numbers);
        if (truth != null) truth.plan.renumber(numbers);
        numbered = mesh.fans();
    }
}
