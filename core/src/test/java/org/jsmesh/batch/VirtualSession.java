package org.jsmesh.batch;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.throughput.ResponseSamples;
import org.jsmesh.throughput.ThroughputEstimator;

/** A whole streaming client in virtual time: rounds of T on a {@link VirtualLink}. */
final class VirtualSession {
    private final ThroughputEstimator estimator = new ThroughputEstimator();
    private final BatchIndex index;
    private final VirtualLink link;
    private final List<BatchRequest> requests = new ArrayList<>();
    private long received;

    /** What the user saw of one round. */
    record Seen(double waitShare, double detailShare, int requests, long bytes) {}

    VirtualSession(BatchIndex index, VirtualLink link) {
        this.index = index;
        this.link = link;
    }

    List<BatchRequest> requests() {
        return requests;
    }

    /** Bytes held. */
    long received() {
        return received;
    }

    Seen refine(double waitMillis) {
        double begin = link.now;
        long before = received;
        RefinementRound round = new RefinementRound(estimator, begin, waitMillis);
        long[] shown = {-1};
        double[] shownAt = {0};
        int asked = 0;
        double end = begin;
        BatchRequest request;
        while (shown[0] < 0
                && (request = round.next(link.now, received < Math.min(index.end(0), 600) ? null : index, received))
                        != null) {
            requests.add(request);
            asked++;
            long start = received;
            ResponseSamples response =
                    link.read(Math.min(request.bytes(), index.archiveBytes() - received), (now, left, samples) -> {
                        if (now < round.deadlineMillis() || start + samples.bytes() < index.end(0)) return true;
                        if (shown[0] < 0) {
                            shown[0] = start + samples.bytes();
                            shownAt[0] = now;
                        }
                        return round.mayDrain(now, left, samples, false);
                    });
            received += response.bytes();
            estimator.learn(response);
            end = link.now;
        }
        long at = shown[0] < 0 ? received : shown[0];
        double wait = shown[0] < 0 ? end - begin : Math.max(waitMillis, shownAt[0] - begin);
        if (received < index.end(0)) throw new AssertionError("no base");
        double detail =
                (at - before) / Math.min(link.possible(begin, begin + waitMillis), index.archiveBytes() - before);
        return new Seen(wait / waitMillis, detail, asked, at - before);
    }
}
