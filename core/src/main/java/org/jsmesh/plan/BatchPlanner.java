package org.jsmesh.plan;

import org.jsmesh.archive.BatchIndex;

/**
 * The one rule that turns a budget of bytes into whole batches: the most batches that fit into throughput × wait, at
 * least one, never beyond the end (section 5.2 of Chen and Nishita 2002). Clients that send ranges and the server's
 * {@code patches} resource both use it.
 */
public final class BatchPlanner {
    private BatchPlanner() {}

    /**
     * Plans whole batches from the start of one.
     *
     * @param index of the archive
     * @param fromBatch the first batch that is still missing, 0 to {@code index.size()}
     * @param bytesPerSecond the estimated throughput
     * @param waitMillis the time that the transmission may take
     * @return the batch after the last one to send: more than {@code fromBatch} unless that is already the end
     * @throws IllegalArgumentException when an argument is negative, not a number or beyond the end
     */
    public static int plan(BatchIndex index, int fromBatch, double bytesPerSecond, double waitMillis) {
        if (fromBatch < 0 || fromBatch > index.size()) {
            throw new IllegalArgumentException("batch " + fromBatch + " of " + index.size());
        }
        if (fromBatch == index.size()) return fromBatch;
        return planFromByte(index, index.offset(fromBatch), bytesPerSecond, waitMillis);
    }

    /**
     * Plans whole batches from any byte, for a client whose last response stopped within a batch.
     *
     * @param index of the archive
     * @param fromByte bytes held already, 0 to the size of the archive
     * @param bytesPerSecond the estimated throughput
     * @param waitMillis the time that the transmission may take
     * @return the batch after the last one to send
     * @throws IllegalArgumentException when an argument is negative, not a number or beyond the end
     */
    public static int planFromByte(BatchIndex index, long fromByte, double bytesPerSecond, double waitMillis) {
        if (!(bytesPerSecond >= 0))
            throw new IllegalArgumentException("bytes per second: " + WholeNumber.of(bytesPerSecond));
        if (!(waitMillis >= 0))
            throw new IllegalArgumentException("wait in milliseconds: " + WholeNumber.of(waitMillis));
        if (fromByte < 0 || fromByte > index.archiveBytes()) {
            throw new IllegalArgumentException("byte " + fromByte + " of " + index.archiveBytes());
        }
        double budget = Math.floor(bytesPerSecond * waitMillis / 1000);
        if (budget >= index.archiveBytes() - fromByte) return index.size();
        int begun = index.batchesWithin(fromByte);
        int end = index.batchesWithin(fromByte + (long) budget);
        return Math.min(Math.max(end, begun + 1), index.size());
    }
}
