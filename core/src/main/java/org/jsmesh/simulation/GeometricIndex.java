package org.jsmesh.simulation;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;

/**
 * Indexes of archives that do not exist. Their batches are as large as the format allows: a twentieth of what is before
 * them, at least 1 KiB and at most 64 KiB.
 */
public final class GeometricIndex {
    private static final int LEAST_BYTES = 1024;
    private static final int MOST_BYTES = 65_536;
    private static final int BASE_FACES = 100;
    private static final int BYTES_PER_FACE = 4;

    private GeometricIndex() {}

    /**
     * Makes an index.
     *
     * @param baseBytes bytes of the first batch, which holds the base
     * @param archiveBytes bytes of the whole archive, base included, at least {@code baseBytes}
     * @return an index whose last batch ends there
     */
    public static BatchIndex of(int baseBytes, long archiveBytes) {
        BatchIndexBuilder builder = new BatchIndexBuilder();
        int faces = BASE_FACES;
        builder.add(BatchKind.BASE, baseBytes, 0).after(faces, faces / 2 + 2, 5);
        for (long at = baseBytes; at < archiveBytes; ) {
            int bytes = (int) Math.min(Math.min(Math.max(LEAST_BYTES, at / 20), MOST_BYTES), archiveBytes - at);
            faces += bytes / BYTES_PER_FACE;
            builder.add(BatchKind.SPLITS, bytes, bytes / (2 * BYTES_PER_FACE))
                    .after(faces, faces / 2 + 2, 500.0 / faces)
                    .in(1, 1);
            at += bytes;
        }
        return builder.build();
    }
}
