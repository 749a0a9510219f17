package org.jsmesh.servlet.http;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.ServletOutputStream;
import jakarta.servlet.WriteListener;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;

/**
 * Sends bytes as fast as the reader takes them; those of an archive come from the mapped file. No thread waits for a
 * slow reader, and nothing is copied to the heap here. A container may copy what the connection does not take at once,
 * at most a portion. When sending fails, the answer is cut, so that a body is never silently short of its announced
 * length.
 */
public final class ResponseSender implements WriteListener {
    private static final Logger LOG = System.getLogger(ResponseSender.class.getName());

    /** Portion of bytes in memory: small enough for a slow reader to take within the time that servers grant. */
    private static final int PORTION_BYTES = 1 << 16;

    private final AsyncContext async;
    private final ServletOutputStream out;
    private final Source source;
    private final long end;
    private final int portionBytes;
    private long at;

    /** Where bytes come from. */
    public interface Source {
        /** Some of the bytes from {@code offset} on, at least one and at most {@code length}. */
        ByteBuffer slice(long offset, long length);
    }

    private ResponseSender(
            AsyncContext async, ServletOutputStream out, Source source, long offset, long length, int portionBytes) {
        this.async = async;
        this.out = out;
        this.source = source;
        at = offset;
        end = offset + length;
        this.portionBytes = portionBytes;
    }

    /**
     * Goes on after the servlet has returned. The header must be complete, with a Content-Length of {@code length}, at
     * least 1.
     *
     * @param portionBytes most bytes that are handed to the container at once
     */
    public static void start(
            HttpServletRequest request,
            HttpServletResponse response,
            Source source,
            long offset,
            long length,
            int portionBytes)
            throws IOException {
        ServletOutputStream out = response.getOutputStream();
        AsyncContext async = request.startAsync();
        // Containers watch for connections where nothing moves; a whole archive may take any time.
        async.setTimeout(0);
        out.setWriteListener(new ResponseSender(async, out, source, offset, length, portionBytes));
    }

    /** The same for bytes that are in memory, which must not change. */
    static void start(HttpServletRequest request, HttpServletResponse response, byte[] body) throws IOException {
        Source source = (offset, length) -> ByteBuffer.wrap(body, (int) offset, (int) length);
        start(request, response, source, 0, body.length, PORTION_BYTES);
    }

    @Override
    public void onWritePossible() throws IOException {
        while (out.isReady()) {
            if (at == end) {
                async.complete();
                return;
            }
            // Every write has its own buffer, because the container may read it until the stream is ready again.
            ByteBuffer portion = source.slice(at, Math.min(portionBytes, end - at));
            at += portion.remaining();
            write(portion);
        }
    }

    private void write(ByteBuffer portion) throws IOException {
        try {
            out.write(portion);
        } catch (InternalError e) {
            throw new IOException("the archive's file was cut while it was sent", e);
        }
    }

    @Override
    public void onError(Throwable failure) {
        LOG.log(Level.DEBUG, "An answer was cut", failure);
        HttpServletResponse response = (HttpServletResponse) async.getResponse();
        if (!response.isCommitted()) {
            // Nobody may keep what the header says of the bytes that do not come.
            response.reset();
            response.setStatus(HttpServletResponse.SC_INTERNAL_SERVER_ERROR);
            response.setHeader("Cache-Control", "no-store");
        }
        async.complete();
    }
}
