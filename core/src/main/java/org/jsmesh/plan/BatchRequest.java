package org.jsmesh.plan;

/**
 * What to ask for next: a range of bytes that ends with a batch. {@code BatchPlanner.plan(index, fromBatch,
 * bytesPerSecond, waitMillis)} gives the same {@code endBatch}, so a client may send either the range or these numbers.
 *
 * @param fromByte first byte to ask for
 * @param endByte the byte after the last one to ask for
 * @param fromBatch first batch that is not complete yet
 * @param endBatch the batch after the last one to ask for; −1 when the index is not known yet and the range is a mere
 *     prefix
 * @param bytesPerSecond the estimate used, in whole bytes per second; nominal for the first request, which has no
 *     estimate
 * @param waitMillis the time that the bytes may take at that estimate
 */
public record BatchRequest(
        long fromByte, long endByte, int fromBatch, int endBatch, long bytesPerSecond, int waitMillis) {
    /** {@return the number of bytes asked for} */
    public long bytes() {
        return endByte - fromByte;
    }
}
