package org.jsmesh.store;

import java.io.IOException;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;

/** Reads the header of an archive. */
interface HeaderReader {
    /** Bytes that a decoder is fed at a time. */
    int BLOCK = 1 << 13;

    /** Feeds a decoder until the header has arrived, and not much further than that. */
    HeaderReader DECODER = archive -> {
        ArchiveDecoder decoder = new ArchiveDecoder();
        for (long at = 0; at < archive.bytes() && decoder.header() == null; ) {
            byte[] block = archive.copy(at, (int) Math.min(BLOCK, archive.bytes() - at));
            decoder.feed(block, 0, block.length);
            at += block.length;
        }
        if (decoder.header() == null)
            throw new MalformedStreamException(archive.bytes(), "the file ends within its header");
        return decoder.header();
    };

    /**
     * @param archive its bytes can be read; it has no header yet
     * @throws MalformedStreamException when the bytes are no archive
     * @throws IOException when they cannot be read
     */
    ArchiveHeader read(Archive archive) throws IOException;
}
