package org.jsmesh.session;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;

/** Waits that a user can cancel. */
final class Waiting {
    /** How long a cancelled wait may go on. */
    static final long SLICE_MILLIS = 50;

    private Waiting() {}

    /** Waits for a result; cancels it when the user cancels. */
    static <T> T await(CompletableFuture<T> future, BooleanSupplier cancelled) throws IOException {
        while (true) {
            try {
                return future.get(SLICE_MILLIS, TimeUnit.MILLISECONDS);
            } catch (TimeoutException e) {
                if (!cancelled.getAsBoolean()) continue;
                future.cancel(true);
                throw new CancellationException("cancelled");
            } catch (ExecutionException e) {
                throw e.getCause() instanceof IOException io ? io : new IOException(e.getCause());
            } catch (InterruptedException e) {
                future.cancel(true);
                Thread.currentThread().interrupt();
                throw new CancellationException("interrupted");
            }
        }
    }

    /** Waits for some time; throws when the user cancels. */
    static void pause(double millis, BooleanSupplier cancelled) {
        pause(millis, () -> false, cancelled);
    }

    /** Waits for some time, or until the user wants to wait no longer; throws when the user cancels. */
    static void pause(double millis, BooleanSupplier hurried, BooleanSupplier cancelled) {
        long end = System.nanoTime() + (long) (millis * 1e6);
        while (true) {
            if (cancelled.getAsBoolean()) throw new CancellationException("cancelled");
            long left = (end - System.nanoTime()) / 1_000_000;
            if (left <= 0 || hurried.getAsBoolean()) return;
            try {
                Thread.sleep(Math.min(left, SLICE_MILLIS));
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new CancellationException("interrupted");
            }
        }
    }
}
