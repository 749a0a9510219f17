package org.jsmesh.simulation;

import java.util.function.DoubleUnaryOperator;
import java.util.function.Supplier;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.RoundPlanner;

/**
 * Somebody who looks at one archive in rounds of the same wait, over a link in virtual time. Deterministic; not
 * thread-safe.
 */
public final class SimulatedVisitor {
    private final BatchIndex index;
    private final VirtualLink link;
    private final VirtualLink oracle;
    private final SimulatedClient client;
    private long received;
    private int asked;

    /**
     * What the visitor sees when a round ends.
     *
     * @param waitMillis from asking to seeing
     * @param requests sent in the round
     * @param bytes held then
     * @param beforeBytes held when the round began
     * @param possibleBytes what a client that knows the link's course would have got within the wait, with a connection
     *     of its own that is never closed, and one request per round for just so much
     */
    public record Round(double waitMillis, int requests, long bytes, long beforeBytes, long possibleBytes) {}

    SimulatedVisitor(BatchIndex index, Supplier<VirtualLink> links, SimulatedClient client) {
        this.index = index;
        link = links.get();
        oracle = links.get();
        this.client = client;
    }

    /**
     * A visitor with jSM's planner.
     *
     * @param index of the archive
     * @param trace kind of the link
     * @param seed of the link's course
     * @param version of HTTP that client and server speak
     * @param roundTripMillis from a request to the first byte of its response
     * @return a visitor who holds no bytes yet, at time 0 of the link
     */
    public static SimulatedVisitor of(
            BatchIndex index, LinkTrace trace, long seed, HttpVersion version, double roundTripMillis) {
        DoubleUnaryOperator rate = trace.course().bitsPerSecondAt(seed);
        return new SimulatedVisitor(
                index,
                () -> new VirtualLink(rate, trace.meanBitsPerSecond(), version, roundTripMillis, 0),
                new PlannedClient());
    }

    /** {@return the number of bytes held, those of incomplete batches included} */
    public long received() {
        return received;
    }

    /** {@return the number of bytes that crossed the link for nobody: those of responses given up} */
    public long wastedBytes() {
        return link.wastedBytes();
    }

    /**
     * Runs one round. A response that is under way at its end goes on.
     *
     * @param waitMillis how long the visitor is willing to wait; the first round lasts until the base is there
     * @return what the visitor sees at the end of the round
     */
    public Round refine(double waitMillis) {
        double begin = link.now();
        long before = received;
        int requests = asked;
        client.beginRound(begin, waitMillis);
        while (true) {
            if (!link.isBusy() && !ask()) break;
            advance();
            if (client.isOver(link.now(), received >= index.end(0))) break;
        }
        return new Round(
                link.now() - begin,
                asked - requests,
                received,
                before,
                Math.min(oracle.mostBytes(begin, begin + waitMillis), index.archiveBytes() - before));
    }

    /** Looks at the model for some time. */
    void rest(double millis) {
        double end = link.now() + millis;
        while (link.now() < end) {
            if (link.isBusy() && !client.mayGoOn(link.now(), link.bytesLeft())) {
                link.cancel();
                client.ended(link.now());
            }
            advance();
        }
    }

    private boolean ask() {
        long end = client.next(link.now(), received < headerBytes() ? null : index, received);
        if (end < 0) return false;
        asked++;
        client.sent(link.now());
        link.ask(Math.min(end, index.archiveBytes()) - received);
        return true;
    }

    private void advance() {
        boolean busy = link.isBusy();
        long bytes = link.advance();
        received += bytes;
        if (bytes > 0) client.arrived(link.now(), (int) bytes);
        if (busy && !link.isBusy()) client.ended(link.now());
    }

    /** Bytes that must be there before the index can be read. The index fills most of what is before the base. */
    private long headerBytes() {
        return Math.min(index.end(0), RoundPlanner.FIRST_REQUEST_BYTES);
    }
}
