package org.jsmesh.servlet;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.http.HttpServletRequest;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Lets requests wait a moment for an archive, so that most need not ask twice. No thread waits. A wait is short and
 * there are few at a time, because a client that has gone away is not always noticed. Thread-safe.
 */
final class Waits {
    /** Longest wait for an answer that means nothing without the archive. */
    static final long MILLIS = 2000;

    private static final String WAITED = Waits.class.getName() + ".waited";
    private static final int MOST_FOR_ENCODINGS = 256;
    private static final int MOST_FOR_OPENINGS = 2048;

    private final AtomicInteger forEncodings = new AtomicInteger();
    private final AtomicInteger forOpenings = new AtomicInteger();

    /**
     * Dispatches the request again when the archive is there or the wait is over.
     *
     * @param isOpening whether the archive exists and is only opened: those who wait for that are not crowded out by
     *     those who wait for encodings
     * @return false when the request has waited already, or too many wait: then it must be answered now
     */
    boolean begin(HttpServletRequest request, CompletableFuture<?> archive, boolean isOpening, long millis) {
        if (request.getAttribute(WAITED) != null) return false;
        AtomicInteger waiting = isOpening ? forOpenings : forEncodings;
        if (waiting.incrementAndGet() > (isOpening ? MOST_FOR_OPENINGS : MOST_FOR_ENCODINGS)) {
            waiting.decrementAndGet();
            return false;
        }
        request.setAttribute(WAITED, true);
        AsyncContext async = request.startAsync();
        async.setTimeout(0);
        archive.copy().orTimeout(millis, TimeUnit.MILLISECONDS).whenComplete((ready, late) -> {
            waiting.decrementAndGet();
            comeBack(async);
        });
        return true;
    }

    private static void comeBack(AsyncContext async) {
        try {
            async.dispatch();
        } catch (IllegalStateException e) {
            // The client has gone, and the container has ended the exchange.
        }
    }
}
