package org.jsmesh.servlet;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.jsmesh.servlet.http.ResponseSender;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ArchiveReader;

/** The bytes of an archive for one answer. */
final class ArchiveSource implements ResponseSender.Source {
    private final ArchiveReader reader;

    private ArchiveSource(ArchiveReader reader) {
        this.reader = reader;
    }

    /** Null when the archive was closed. */
    static ArchiveSource of(Archive archive, long length) {
        ArchiveReader reader = archive.reader(length);
        return reader == null ? null : new ArchiveSource(reader);
    }

    @Override
    public ByteBuffer next(long offset, long length) throws IOException {
        return reader.next(offset, length);
    }

    @Override
    public void ended(boolean whole) {
        // A container may still look at the last buffer of an answer that it cuts.
        if (whole) reader.close();
        else reader.abandon();
    }
}
