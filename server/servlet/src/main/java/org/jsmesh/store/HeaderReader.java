package org.jsmesh.store;

import java.nio.ByteBuffer;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.mesh.MalformedStreamException;

/** Reads the header of an archive. */
interface HeaderReader {
    /** Feeds a decoder until the header has arrived, and not much further than that. */
    HeaderReader DECODER = archive -> {
        ArchiveDecoder decoder = new ArchiveDecoder();
        byte[] block = new byte[1 << 13];
        for (long at = 0; at < archive.bytes() && decoder.header() == null; ) {
            ByteBuffer slice = archive.slice(at, Math.min(block.length, archive.bytes() - at));
            int count = slice.remaining();
            slice.get(block, 0, count);
            decoder.feed(block, 0, count);
            at += count;
        }
        if (decoder.header() == null)
            throw new MalformedStreamException(archive.bytes(), "the file ends within its header");
        return decoder.header();
    };

    /**
     * @param archive its bytes can be read; it has no header yet
     * @throws MalformedStreamException when the bytes are no archive
     */
    ArchiveHeader read(Archive archive) throws MalformedStreamException;
}
