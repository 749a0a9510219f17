package org.jsmesh.test;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/** Waits for what other threads or processes do, but not for ever. */
public final class Await {
    private static final long PATIENCE_SECONDS = 120;
    private static final int PACE_MILLIS = 5;

    private Await() {}

    /** What is waited for. */
    public interface Condition {
        boolean holds() throws Exception;
    }

    /**
     * Asks again and again until a condition holds.
     *
     * @param what is waited for, as the end of "waited 120 s in vain for"
     * @throws AssertionError when it takes too long
     */
    public static void until(String what, Condition condition) throws Exception {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!condition.holds()) {
            if (System.nanoTime() - end > 0) throw late(what);
            Thread.sleep(PACE_MILLIS);
        }
    }

    /**
     * Waits until a latch is open.
     *
     * @param what is waited for, as the end of "waited 120 s in vain for"
     * @throws AssertionError when it takes too long
     */
    public static void open(String what, CountDownLatch latch) throws InterruptedException {
        if (!latch.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) throw late(what);
    }

    private static AssertionError late(String what) {
        return new AssertionError("waited " + PATIENCE_SECONDS + " s in vain for " + what);
    }
}
