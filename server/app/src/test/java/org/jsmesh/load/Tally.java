package org.jsmesh.load;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicLong;

/** What all viewers saw. Used on the viewers' loop, and read when that has ended. */
final class Tally {
    private static final int MOST_ERRORS = 20;

    /**
     * One round of a viewer.
     *
     * @param first of its viewer
     * @param waitShare of T
     * @param detailShare bytes of whole batches shown beside those that the link could have brought
     * @param hit by a fault that the test injected
     * @param afterHit the round before it was
     * @param complete the original was there at its end
     */
    record Round(
            SpeedClass speed,
            boolean first,
            double waitShare,
            double detailShare,
            int requests,
            boolean hit,
            boolean afterHit,
            boolean complete) {}

    final List<Round> rounds = new ArrayList<>();
    final Map<SpeedClass, Integer> completed = new TreeMap<>(java.util.Comparator.comparing(SpeedClass::bitsPerSecond));
    final Map<String, Long> statuses = new TreeMap<>();
    final List<String> errors = new ArrayList<>();
    final AtomicLong decoded = new AtomicLong();
    final AtomicLong decodedWrongly = new AtomicLong();
    int started;
    int wrongEnds;
    int unexplainedBreaks;
    int refusals;
    long requests;
    long bodyBytes;
    long bytesTwice;
    long lateBytes;
    long givenUp;
    int stallsTimedOut;
    final List<Double> stopSeconds = new ArrayList<>();

    void status(int status, boolean retryAfter) {
        String name = status == 503 ? "503 with" + (retryAfter ? "" : "out") + " Retry-After" : "" + status;
        statuses.merge(name, 1L, Long::sum);
    }

    void completed(SpeedClass speed) {
        completed.merge(speed, 1, Integer::sum);
    }

    /** Notes what went wrong; only the first ones are kept. */
    void error(String what) {
        if (errors.size() < MOST_ERRORS) errors.add(what);
    }

    int completedViewers() {
        return completed.values().stream().mapToInt(n -> n).sum();
    }

    /** Answers that no server should have given: all but those that were asked for, and 503 with Retry-After. */
    long wrongStatuses() {
        return statuses.entrySet().stream()
                .filter(e -> !List.of("200", "206", "503 with Retry-After").contains(e.getKey()))
                .mapToLong(Map.Entry::getValue)
                .sum();
    }

    long serverErrors() {
        return statuses.entrySet().stream()
                .filter(e -> e.getKey().startsWith("5") && !e.getKey().equals("503 with Retry-After"))
                .mapToLong(Map.Entry::getValue)
                .sum();
    }
}
