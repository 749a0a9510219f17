package org.jsmesh.test;

import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.archive.coding.ArchiveLayout;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;

/** What somebody does who changes a picture in an archive and hides it from checksums. */
public final class AlteredPicture {
    /** A byte of the picture, early enough to be of the first one. */
    private static final int PLACE = 20;

    private AlteredPicture() {}

    /** The archive with a byte of its first picture changed, and the batch's checksum right. */
    public static byte[] in(byte[] archive) throws MalformedStreamException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        BatchIndex index = decoder.header().batches();
        int batch = 0;
        while (index.kind(batch) != BatchKind.TEXTURE) batch++;
        byte[] altered = archive.clone();
        int at = (int) index.offset(batch);
        int length = index.bytes(batch) - ArchiveLayout.CRC_BYTES;
        altered[at + Math.min(PLACE, length - 1)] ^= 1;
        ArchiveLayout.putInt(altered, at + length, ArchiveLayout.crc(altered, at, length));
        return altered;
    }
}
