package org.jsmesh.archive;

/** Recomputes the checksums of an archive whose bytes were changed. */
final class Checksums {
    private Checksums() {}

    /** @param original index of the archive before the change: the batches are taken to lie where they lay */
    static void mend(byte[] bytes, BatchIndex original) {
        int header = ArchiveLayout.PREFIX_BYTES + ArchiveLayout.getInt(bytes, 4);
        if (header < 0 || header + 4 > bytes.length) return;
        ArchiveLayout.putInt(bytes, header, ArchiveLayout.crc(bytes, 0, header));
        for (int b = 0; b < original.size(); b++) {
            int from = b == 0 ? header + 4 : (int) original.offset(b);
            int length = (int) original.end(b) - 4 - from;
            ArchiveLayout.putInt(bytes, from + length, ArchiveLayout.crc(bytes, from, length));
        }
    }
}
