package org.jsmesh.archive;

import org.jsmesh.archive.coding.ArchiveLayout;

/** Makes the checksums of changed or invented bytes right. */
public final class Checksums {
    private Checksums() {}

    /** @param original index of the archive before the change: the batches are taken to lie where they lay */
    public static void mend(byte[] bytes, BatchIndex original) {
        int at = ArchiveLayout.OPENING_BYTES_AT;
        int length = 0;
        int shift = 0;
        do {
            length |= (bytes[at] & 0x7f) << shift;
            shift += 7;
        } while (bytes[at++] < 0 && shift < 28);
        int header = at + length;
        if (header > bytes.length - 4) return;
        ArchiveLayout.putInt(bytes, header, ArchiveLayout.crc(bytes, 0, header));
        for (int b = 0; b < original.size(); b++) {
            int from = b == 0 ? header + 4 : (int) original.offset(b);
            int payload = (int) original.end(b) - 4 - from;
            if (payload < 0) continue; // the head now says that it goes on beyond the base
            ArchiveLayout.putInt(bytes, from + payload, ArchiveLayout.crc(bytes, from, payload));
        }
    }

    /** Makes bytes begin like an archive, with the right checksum after an opening of {@code openingBytes} bytes. */
    static void pretend(byte[] bytes, int openingBytes) {
        System.arraycopy(ArchiveLayout.MAGIC, 0, bytes, 0, 3);
        bytes[3] = ArchiveLayout.VERSION;
        bytes[ArchiveLayout.FEATURES_AT] = 0;
        int end = ArchiveLayout.putVarint(bytes, ArchiveLayout.OPENING_BYTES_AT, openingBytes) + openingBytes;
        ArchiveLayout.putInt(bytes, end, ArchiveLayout.crc(bytes, 0, end));
    }
}
