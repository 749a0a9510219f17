package org.jsmesh.session;

/**
 * One round of a session, as its trace keeps it.
 *
 * @param waitMillis from the call until the result was shown
 * @param plannedWaitMillis the wait T that was asked for; for the whole original the time that the estimate gave for
 *     it, 0 without an estimate
 * @param plannedBytes bytes of the archive that the round's requests asked for beyond those shown before
 * @param bytes bytes of the archive that arrived since the end of the round before; those that arrived after that
 *     round's deadline count here
 * @param bytesPerSecond the throughput estimate at the end
 * @param batches applied in all
 * @param faces shown
 * @param errorMean mean distance to the original, in % of the bounding box's diagonal
 */
public record RoundReport(
        long waitMillis,
        long plannedWaitMillis,
        long plannedBytes,
        long bytes,
        long bytesPerSecond,
        int batches,
        int faces,
        double errorMean) {}
