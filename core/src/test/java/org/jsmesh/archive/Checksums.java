package org.jsmesh.archive;

import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.archive.coding.ArchivePrefix;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;

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

    /** Feeds an archive and makes each checksum right before the decoder sees it, wherever changed bytes put it. */
    public static void feedMended(ArchiveDecoder decoder, byte[] bytes) throws MalformedStreamException {
        int head = 0;
        for (int n = ArchiveLayout.OPENING_BYTES_AT + 1; head == 0 && n <= bytes.length; n++)
            head = ArchivePrefix.headBytes(bytes, n);
        if (head == 0 || head > bytes.length) {
            decoder.feed(bytes, 0, bytes.length);
            return;
        }
        mend(bytes, 0, head);
        decoder.feed(bytes, 0, head);
        int from = head;
        int begin = 0; // of the batch
        for (int batch = 0; !decoder.isComplete(); batch++) {
            long end = (long) begin + decoder.index().bytes(batch);
            if (end > bytes.length || end < from + (long) ArchiveLayout.CRC_BYTES) break;
            mend(bytes, from, (int) end);
            decoder.feed(bytes, from, (int) end - from);
            from = begin = (int) end;
        }
        decoder.feed(bytes, from, bytes.length - from);
    }

    private static void mend(byte[] bytes, int from, int to) {
        int at = to - ArchiveLayout.CRC_BYTES;
        ArchiveLayout.putInt(bytes, at, ArchiveLayout.crc(bytes, from, at - from));
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
