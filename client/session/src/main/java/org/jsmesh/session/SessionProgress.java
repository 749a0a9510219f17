package org.jsmesh.session;

import org.jsmesh.archive.BatchIndex;

/**
 * How far a session is.
 *
 * @param bytes of the archive received
 * @param totalBytes of the archive; −1 until the index has arrived
 * @param batches applied
 * @param totalBatches of the archive; −1 until the index has arrived
 * @param faces shown
 * @param totalFaces of the original; −1 until the header has arrived
 * @param level of the batch last applied: 0 for the base, 1 for the coarsest level
 * @param errorMean mean distance to the original, in % of the bounding box's diagonal
 * @param bytesPerSecond the throughput estimate; 0 before the first response
 */
public record SessionProgress(
        long bytes,
        long totalBytes,
        int batches,
        int totalBatches,
        int faces,
        int totalFaces,
        int level,
        double errorMean,
        double bytesPerSecond) {
    /** How far the archive is at this throughput estimate. */
    static SessionProgress of(ReceivedArchive archive, double bytesPerSecond) {
        BatchIndex index = archive.index();
        if (index == null) return new SessionProgress(archive.bytes(), -1, 0, -1, 0, -1, 0, 0, bytesPerSecond);
        int last = archive.batches() - 1;
        return new SessionProgress(
                archive.bytes(),
                index.archiveBytes(),
                last + 1,
                index.size(),
                last < 0 ? 0 : index.faces(last),
                archive.header().faces(),
                last < 0 ? 0 : index.level(last),
                last < 0 ? 0 : index.errorMean(last),
                bytesPerSecond);
    }

    /** {@return the share of the archive's bytes that has arrived, 0 to 1; 0 until its size is known} */
    public double fraction() {
        return totalBytes <= 0 ? 0 : (double) bytes / totalBytes;
    }

    /** {@return true when every batch is applied} */
    public boolean isComplete() {
        return batches == totalBatches;
    }
}
