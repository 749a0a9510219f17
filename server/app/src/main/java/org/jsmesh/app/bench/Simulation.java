package org.jsmesh.app.bench;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.simulation.HttpVersion;
import org.jsmesh.simulation.LinkTrace;
import org.jsmesh.simulation.SimulatedVisitor;

/**
 * A visitor who asks for one round after the other, in virtual time, with the planner that the clients use and without
 * a network. Deterministic.
 */
public final class Simulation {
    private final BatchIndex index;
    private final SimulatedVisitor visitor;

    /**
     * What the visitor sees when a round ends.
     *
     * @param waitMillis from asking to seeing
     * @param requests sent in the round
     * @param bytes held when it ends
     * @param batches shown when it ends
     * @param faces of the mesh shown
     * @param errorMean of that mesh, in % of the diagonal
     * @param errorQuantile distance that 99.9% of it does not exceed, likewise
     * @param errorBound distance that no point of it is expected to exceed, likewise
     */
    public record Row(
            double waitMillis,
            int requests,
            long bytes,
            int batches,
            int faces,
            double errorMean,
            double errorQuantile,
            double errorBound) {}

    /**
     * @param bitsPerSecond of the link
     * @param roundTripMillis from a request to the first byte of its response; a new connection takes one more
     */
    public Simulation(BatchIndex index, double bitsPerSecond, double roundTripMillis) {
        this(index, LinkTrace.constant("constant", bitsPerSecond), HttpVersion.HTTP_1_1, roundTripMillis);
    }

    public Simulation(BatchIndex index, LinkTrace trace, HttpVersion version, double roundTripMillis) {
        this.index = index;
        visitor = SimulatedVisitor.of(index, trace, 1, version, roundTripMillis);
    }

    /** Rounds of the same wait until the original is shown, at most {@code most}. */
    public List<Row> run(double waitMillis, int most) {
        return run(waitMillis, most, -1);
    }

    /** The same, but the visitor stops when 99.9% of the surface is off by no more than a value. */
    public List<Row> run(double waitMillis, int most, double goodQuantile) {
        List<Row> rows = new ArrayList<>();
        long shown = 0;
        while (rows.size() < most && shown < index.archiveBytes()) {
            Row row = row(visitor.refine(waitMillis));
            shown = row.bytes();
            rows.add(row);
            if (row.errorQuantile() <= goodQuantile) break;
        }
        return rows;
    }

    private Row row(SimulatedVisitor.Round round) {
        int batches = index.batchesWithin(round.bytes());
        return new Row(
                round.waitMillis(),
                round.requests(),
                round.bytes(),
                batches,
                index.faces(batches - 1),
                index.errorMean(batches - 1),
                index.errorQuantile(batches - 1),
                index.errorBound(batches - 1));
    }
}
