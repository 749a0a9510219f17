package org.jsmesh.servlet.http;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.AsyncEvent;
import jakarta.servlet.AsyncListener;
import jakarta.servlet.ServletOutputStream;
import jakarta.servlet.WriteListener;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Sends bytes as fast as the reader takes them. No thread waits for a slow reader. When anything fails, the answer is
 * cut, so that a body is never silently short of its announced length, and no exchange stays open.
 */
public final class ResponseSender implements WriteListener {
    private static final Logger LOG = System.getLogger(ResponseSender.class.getName());

    /** Portion of bytes in memory: small enough for a slow reader to take within the time that servers grant. */
    private static final int PORTION_BYTES = 1 << 16;

    /** Attribute of a request whose answer is to be cut. */
    private static final String CUT = ResponseSender.class.getName() + ".cut";

    private static final CompletableFuture<?> HERE = CompletableFuture.completedFuture(null);

    private final AsyncContext async;
    private final ServletOutputStream out;
    private final Source source;
    private final long end;
    private final AtomicBoolean ended = new AtomicBoolean();
    private long at;
    private volatile boolean isSourceLost;
    private boolean isBegun;

    /** Where bytes come from. */
    public interface Source {
        /**
         * Some of the bytes from {@code offset} on, at least one and at most {@code length}. They stay as they are
         * until the next call.
         */
        ByteBuffer next(long offset, long length) throws IOException;

        /** Completes when {@link #next} can be called, which then gives the bytes or says why it cannot. */
        default CompletableFuture<?> ready(long offset, long length) {
            return HERE;
        }

        /** No more bytes are wanted. Called once; {@code whole} says whether all went out. */
        default void ended(boolean whole) {}
    }

    private ResponseSender(AsyncContext async, ServletOutputStream out, Source source, long offset, long length) {
        this.async = async;
        this.out = out;
        this.source = source;
        at = offset;
        end = offset + length;
    }

    /**
     * Goes on after the servlet has returned. The header must be complete, with a Content-Length of {@code length}, at
     * least 1.
     */
    public static void start(
            HttpServletRequest request, HttpServletResponse response, Source source, long offset, long length)
            throws IOException {
        boolean started = false;
        try {
            ServletOutputStream out = response.getOutputStream();
            AsyncContext async = request.startAsync();
            // Containers watch for connections where nothing moves; a whole archive may take any time.
            async.setTimeout(0);
            ResponseSender sender = new ResponseSender(async, out, source, offset, length);
            async.addListener(new Ending(sender));
            out.setWriteListener(sender);
            started = true;
        } finally {
            if (!started) source.ended(false);
        }
    }

    /** The same for bytes that are in memory, which must not change. */
    static void start(HttpServletRequest request, HttpServletResponse response, byte[] body) throws IOException {
        Source source = (offset, length) -> ByteBuffer.wrap(body, (int) offset, (int) Math.min(length, PORTION_BYTES));
        start(request, response, source, 0, body.length);
    }

    @Override
    public synchronized void onWritePossible() throws IOException {
        // When an exchange has ended, its stream may be another one's.
        while (!ended.get() && out.isReady()) {
            if (at == end) {
                end(true);
                async.complete();
                return;
            }
            CompletableFuture<?> ready = source.ready(at, end - at);
            if (!ready.isDone()) {
                // Nobody calls this until something is written to a stream that is ready.
                ready.whenComplete((bytes, failure) -> resume());
                return;
            }
            // The stream is ready, so the container has done with the bytes before.
            ByteBuffer portion;
            try {
                portion = source.next(at, end - at);
            } catch (IOException | RuntimeException | Error e) {
                isSourceLost = true;
                if (!isBegun && refuse(e)) return;
                throw new IOException("the bytes of an answer cannot be read", e);
            }
            isBegun = true;
            at += portion.remaining();
            out.write(portion);
        }
    }

    /** Goes on, on a thread of the container. */
    private void resume() {
        try {
            async.start(() -> {
                try {
                    onWritePossible();
                } catch (IOException | RuntimeException e) {
                    if (!ended.get()) cut(e);
                }
            });
        } catch (IllegalStateException e) {
            end(false); // the container has ended the exchange meanwhile
        }
    }

    /**
     * Ends an answer outside of what the container calls, where completing it might leave the client waiting for the
     * rest: has the request come back, for {@link #check} to fail.
     */
    private void cut(Exception failure) {
        if (!async.getResponse().isCommitted()) {
            onError(failure);
            return;
        }
        end(false);
        LOG.log(Level.DEBUG, "An answer was cut", failure);
        async.getRequest().setAttribute(CUT, failure);
        async.dispatch();
    }

    /**
     * Where a servlet begins.
     *
     * @throws IOException when the request has come back because its answer is to be cut; the container then closes the
     *     connection
     */
    public static void check(HttpServletRequest request) throws IOException {
        Throwable failure = (Throwable) request.getAttribute(CUT);
        if (failure != null) throw new IOException("an answer was cut: " + failure.getMessage(), failure);
    }

    /** Says why there are no bytes, as long as nothing was sent. */
    private boolean refuse(Throwable reason) throws IOException {
        HttpServletResponse response = (HttpServletResponse) async.getResponse();
        if (response.isCommitted()) return false;
        LOG.log(Level.DEBUG, "An answer was not begun", reason);
        Answer.lost(response, reason.getMessage());
        end(false);
        async.complete();
        return true;
    }

    private synchronized void end(boolean whole) {
        if (ended.compareAndSet(false, true)) source.ended(whole);
    }

    /** Hears of ends that the container brings about. */
    private static final class Ending implements AsyncListener {
        private final ResponseSender sender;

        Ending(ResponseSender sender) {
            this.sender = sender;
        }

        @Override
        public void onComplete(AsyncEvent event) {
            sender.end(false);
        }

        @Override
        public void onTimeout(AsyncEvent event) {
            // There is none.
        }

        @Override
        public void onError(AsyncEvent event) {
            sender.end(false);
        }

        @Override
        public void onStartAsync(AsyncEvent event) {
            // Nothing begins again.
        }
    }

    @Override
    public void onError(Throwable failure) {
        end(false);
        LOG.log(Level.DEBUG, "An answer was cut", failure);
        HttpServletResponse response = (HttpServletResponse) async.getResponse();
        if (!response.isCommitted()) {
            // Nobody may keep what the header says of the bytes that do not come.
            response.reset();
            response.setStatus(
                    isSourceLost
                            ? HttpServletResponse.SC_SERVICE_UNAVAILABLE
                            : HttpServletResponse.SC_INTERNAL_SERVER_ERROR);
            response.setHeader("Cache-Control", "no-store");
            // What the next request finds is another file.
            if (isSourceLost) response.setHeader("Retry-After", "1");
        }
        async.complete();
    }
}
