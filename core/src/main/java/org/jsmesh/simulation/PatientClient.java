package org.jsmesh.simulation;

import java.util.function.DoubleBinaryOperator;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.plan.BatchPlanner;
import org.jsmesh.plan.RoundPlanner;

/**
 * A client that reads every response to its end before it shows anything. It estimates the rate and asks once for what
 * fits into the rest of the wait.
 */
final class PatientClient implements SimulatedClient {
    private final RateEstimate estimate;
    private final int chunkBytes;
    private double deadlineMillis;
    private boolean asked;
    private double startMillis;
    private double firstMillis;
    private double lastMillis;
    private long bytes;

    /** An estimate from whole responses. */
    interface RateEstimate {
        /** Learns that a response of so many bytes took so long. */
        void learn(long bytes, double latencyMillis, double millis);

        double bytesPerSecond();
    }

    private PatientClient(RateEstimate estimate, int chunkBytes) {
        this.estimate = estimate;
        this.chunkBytes = chunkBytes;
    }

    /** Asks for chunks of one size until the wait is over. */
    static PatientClient chunks(int chunkBytes) {
        return new PatientClient(null, chunkBytes);
    }

    /**
     * Section 5.2 of Chen and Nishita 2002: "the bandwidth will be recalculated again by using the downloading file
     * size, transmission time, and the previous network bandwidth", taken as their mean.
     */
    static PatientClient paper() {
        return new PatientClient(new Mean((known, seen) -> known == 0 ? seen : (known + seen) / 2), 0);
    }

    private record Mean(double[] rate, DoubleBinaryOperator update) implements RateEstimate {
        Mean(DoubleBinaryOperator update) {
            this(new double[1], update);
        }

        @Override
        public void learn(long bytes, double latencyMillis, double millis) {
            rate[0] = update.applyAsDouble(rate[0], bytes * 1000 / millis);
        }

        @Override
        public double bytesPerSecond() {
            return rate[0];
        }
    }

    /** After dash.js: .9 × the smaller of two averages with half-lives of 3 and 8 s of the rates of bodies. */
    static PatientClient dash() {
        return new PatientClient(new PlayerEstimate(3, 8, .9), 0);
    }

    private static final class PlayerEstimate implements RateEstimate {
        private final double[] halfLives;
        private final double[] sums = new double[2];
        private final double[] weights = new double[2];
        private final double share;

        PlayerEstimate(double fastSeconds, double slowSeconds, double share) {
            halfLives = new double[] {fastSeconds, slowSeconds};
            this.share = share;
        }

        @Override
        public void learn(long bytes, double latencyMillis, double millis) {
            double seconds = Math.max(1, millis - latencyMillis) / 1000;
            for (int i = 0; i < 2; i++) {
                double kept = Math.pow(.5, seconds / halfLives[i]);
                sums[i] = kept * sums[i] + (1 - kept) * bytes / seconds;
                weights[i] = kept * weights[i] + 1 - kept;
            }
        }

        @Override
        public double bytesPerSecond() {
            return weights[0] == 0 ? 0 : share * Math.min(sums[0] / weights[0], sums[1] / weights[1]);
        }
    }

    @Override
    public void beginRound(double nowMillis, double waitMillis) {
        deadlineMillis = nowMillis + waitMillis;
        asked = false;
    }

    @Override
    public long next(double nowMillis, BatchIndex index, long receivedBytes) {
        if (index == null) return receivedBytes + Math.max(RoundPlanner.FIRST_REQUEST_BYTES, chunkBytes);
        if (receivedBytes >= index.archiveBytes() || nowMillis >= deadlineMillis) return -1;
        if (chunkBytes > 0) return Math.min(receivedBytes + chunkBytes, index.archiveBytes());
        if (asked) return -1;
        asked = true;
        int end =
                BatchPlanner.planFromByte(index, receivedBytes, estimate.bytesPerSecond(), deadlineMillis - nowMillis);
        return index.end(end - 1);
    }

    @Override
    public void sent(double nowMillis) {
        startMillis = nowMillis;
        bytes = 0;
    }

    @Override
    public void arrived(double nowMillis, int count) {
        if (bytes == 0) firstMillis = nowMillis;
        bytes += count;
        lastMillis = nowMillis;
    }

    @Override
    public void ended(double nowMillis) {
        if (estimate != null) estimate.learn(bytes, firstMillis - startMillis, Math.max(1, lastMillis - startMillis));
    }

    @Override
    public boolean isOver(double nowMillis, boolean basePresent) {
        return false;
    }

    @Override
    public boolean mayGoOn(double nowMillis, long bytesLeft) {
        return false;
    }
}
