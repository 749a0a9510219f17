package org.jsmesh.batch;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchIndexBuilder;
import org.jsmesh.archive.BatchKind;

/** Indexes with batches that grow as the format allows. */
final class Indexes {
    private Indexes() {}

    static BatchIndex geometric(int baseBytes, long archiveBytes) {
        BatchIndexBuilder builder = new BatchIndexBuilder();
        builder.add(BatchKind.BASE, baseBytes, 0).after(100, 52, 5);
        long at = baseBytes;
        int faces = 100;
        while (at < archiveBytes) {
            int bytes = (int) Math.min(Math.min(Math.max(1024, at / 20), 65536), archiveBytes - at);
            faces += bytes / 4;
            builder.add(BatchKind.SPLITS, bytes, bytes / 8)
                    .after(faces, faces / 2, 500.0 / faces)
                    .in(1, 1);
            at += bytes;
        }
        return builder.build();
    }
}
