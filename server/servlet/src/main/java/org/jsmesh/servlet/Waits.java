package org.jsmesh.servlet;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.http.HttpServletRequest;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Lets requests wait a moment for an archive, so that most need not ask twice. No thread waits. A wait is short and
 * there are few at a time, because a client that has gone away is not always noticed. Nothing of a wait stays when it
 * is over, however long the encoding takes. Thread-safe.
 */
final class Waits {
    /** Longest wait for an answer that means nothing without the archive. */
    static final long MILLIS = 2000;

    private static final String WAITED = Waits.class.getName() + ".waited";
    private static final int MOST_FOR_ENCODINGS = 256;
    private static final int MOST_FOR_OPENINGS = 2048;
    private static final long LOOK_MILLIS = 10;

    private final AtomicInteger forEncodings = new AtomicInteger();
    private final AtomicInteger forOpenings = new AtomicInteger();
    private final Queue<Wait> waits = new ConcurrentLinkedQueue<>();
    private final AtomicBoolean isLooking = new AtomicBoolean();

    /** @param slots of its kind that are taken */
    private record Wait(AsyncContext async, CompletableFuture<?> archive, long endNanos, AtomicInteger slots) {
        boolean isOver() {
            return archive.isDone() || System.nanoTime() - endNanos > 0;
        }
    }

    /**
     * Dispatches the request again when the archive is there or the wait is over.
     *
     * @param isOpening whether the archive exists and is only opened: those who wait for that are not crowded out by
     *     those who wait for encodings
     * @return false when the request has waited already, or too many wait: then it must be answered now
     */
    boolean begin(HttpServletRequest request, CompletableFuture<?> archive, boolean isOpening, long millis) {
        if (request.getAttribute(WAITED) != null) return false;
        AtomicInteger slots = isOpening ? forOpenings : forEncodings;
        if (slots.incrementAndGet() > (isOpening ? MOST_FOR_OPENINGS : MOST_FOR_ENCODINGS)) {
            slots.decrementAndGet();
            return false;
        }
        request.setAttribute(WAITED, true);
        AsyncContext async = request.startAsync();
        async.setTimeout(0);
        waits.add(new Wait(async, archive, System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(millis), slots));
        if (isLooking.compareAndSet(false, true)) lookSoon();
        return true;
    }

    private void lookSoon() {
        CompletableFuture.delayedExecutor(LOOK_MILLIS, TimeUnit.MILLISECONDS, Runnable::run)
                .execute(this::look);
    }

    private void look() {
        waits.removeIf(wait -> {
            if (!wait.isOver()) return false;
            wait.slots().decrementAndGet();
            comeBack(wait.async());
            return true;
        });
        isLooking.set(false);
        // One may have come in between, and have begun to look.
        if (!waits.isEmpty() && isLooking.compareAndSet(false, true)) lookSoon();
    }

    private static void comeBack(AsyncContext async) {
        try {
            async.dispatch();
        } catch (IllegalStateException e) {
            // The client has gone, and the container has ended the exchange.
        }
    }
}
