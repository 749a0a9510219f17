package org.jsmesh.archive;

/** Makes the checksums of changed or invented bytes right. */
final class Checksums {
    private Checksums() {}

    /** @param original index of the archive before the change: the batches are taken to lie where they lay */
    static void mend(byte[] bytes, BatchIndex original) {
        int header = ArchiveLayout.PREFIX_BYTES + ArchiveLayout.getInt(bytes, ArchiveLayout.HEADER_BYTES_AT);
        if (header < 0 || header > bytes.length - 4) return;
        ArchiveLayout.putInt(bytes, header, ArchiveLayout.crc(bytes, 0, header));
        for (int b = 0; b < original.size(); b++) {
            int from = b == 0 ? header + 4 : (int) original.offset(b);
            int length = (int) original.end(b) - 4 - from;
            if (length < 0) continue; // the header now says that it goes on beyond the base
            ArchiveLayout.putInt(bytes, from + length, ArchiveLayout.crc(bytes, from, length));
        }
    }

    /** Makes bytes begin like an archive, with the right checksum after a header of {@code headerBytes} bytes. */
    static void pretend(byte[] bytes, int headerBytes) {
        System.arraycopy(ArchiveLayout.MAGIC, 0, bytes, 0, 3);
        bytes[3] = ArchiveLayout.VERSION;
        bytes[ArchiveLayout.FEATURES_AT] = 0;
        ArchiveLayout.putInt(bytes, ArchiveLayout.HEADER_BYTES_AT, headerBytes);
        int end = ArchiveLayout.PREFIX_BYTES + headerBytes;
        ArchiveLayout.putInt(bytes, end, ArchiveLayout.crc(bytes, 0, end));
    }
}
