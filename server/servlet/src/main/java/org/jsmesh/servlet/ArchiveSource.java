package org.jsmesh.servlet;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.servlet.http.ResponseSender;
import org.jsmesh.store.ServedArchive;
import org.jsmesh.store.ServedBytes;

/** The bytes of an archive for one answer. */
final class ArchiveSource implements ResponseSender.Source {
    private final ServedBytes reader;

    private ArchiveSource(ServedBytes reader) {
        this.reader = reader;
    }

    /** Null when the archive was closed. */
    static ArchiveSource of(ServedArchive archive, long length) {
        ServedBytes reader = archive.reader(length);
        return reader == null ? null : new ArchiveSource(reader);
    }

    @Override
    public CompletableFuture<?> ready(long offset, long length) {
        return reader.ready(offset, length);
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
