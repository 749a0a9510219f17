package org.jsmesh.upload;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jsmesh.files.AtomicFiles;

/** A model file on its way into the spool folder. It counts only once it is whole. */
public final class Upload implements AutoCloseable {
    private static final String PART = "part";

    private final UploadQueue queue;
    private final Ticket ticket;
    private final String extension;
    private final long mostBytes;
    private boolean taken;

    Upload(UploadQueue queue, Ticket ticket, String extension, long mostBytes) {
        this.queue = queue;
        this.ticket = ticket;
        this.extension = extension;
        this.mostBytes = mostBytes;
    }

    /** The disk of the server does not take what comes. */
    public static final class SpoolException extends IOException {
        private static final long serialVersionUID = 1L;

        SpoolException(IOException cause) {
            super("the spool folder takes no more", cause);
        }
    }

    /**
     * Writes what comes to disk, a little at a time.
     *
     * @param in the body of the request, read to its end and left open
     * @return bytes received; more than allowed if there are more, and then the upload is given up at once
     * @throws SpoolException when they cannot be written
     * @throws IOException when they do not come
     */
    public long receive(InputStream in) throws IOException {
        byte[] block = new byte[1 << 16];
        long bytes = 0;
        try (OutputStream out = create()) {
            for (int count = in.read(block); count >= 0; count = in.read(block)) {
                bytes += count;
                if (bytes > mostBytes) return bytes;
                try {
                    out.write(block, 0, count);
                } catch (IOException e) {
                    throw new SpoolException(e);
                }
            }
        }
        return bytes;
    }

    private OutputStream create() throws SpoolException {
        try {
            ticket.begin();
            return Files.newOutputStream(ticket.folder().resolve(PART), StandardOpenOption.CREATE_NEW);
        } catch (IOException e) {
            throw new SpoolException(e);
        }
    }

    /**
     * Notes that it is whole. From now on it will be encoded, however the server ends.
     *
     * @throws SpoolException when the disk does not take it; then it can only be forgotten
     */
    public void accept() throws SpoolException {
        try {
            Path part = ticket.folder().resolve(PART);
            // Otherwise a power cut may leave an empty file under the name.
            try (FileChannel channel = FileChannel.open(part, StandardOpenOption.WRITE)) {
                channel.force(true);
            }
            AtomicFiles.move(part, ticket.body(extension));
            AtomicFiles.syncFolder(ticket.folder().getParent());
        } catch (IOException e) {
            throw new SpoolException(e);
        }
        taken = true;
        queue.accept(ticket);
    }

    /** Removes all traces of it, unless it was accepted. */
    public void forget() {
        if (!taken) queue.drop(ticket);
        taken = true;
    }

    @Override
    public void close() {
        forget();
    }
}
