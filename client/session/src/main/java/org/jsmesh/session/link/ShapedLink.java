package org.jsmesh.session.link;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/** One link of limited rate and some delay, shared by all connections. Thread-safe. */
public final class ShapedLink {
    private volatile double bytesPerSecond = Double.POSITIVE_INFINITY;
    private long freeNanos = System.nanoTime();
    private final AtomicInteger changes = new AtomicInteger();
    private volatile long delayMillis;
    private volatile long burstNanos = 30_000_000;

    /** The rate from now on. */
    public void setBytesPerSecond(double rate) {
        if (!(rate > 0)) throw new IllegalArgumentException("bytes per second: " + rate);
        synchronized (this) {
            bytesPerSecond = rate;
            freeNanos = System.nanoTime();
            changes.incrementAndGet();
        }
    }

    /** The delay from now on: the time of a round trip. */
    public void setDelayMillis(long millis) {
        delayMillis = millis;
    }

    /**
     * Sets the time that a busy machine may lose and catch up again. After a pause, the link carries as much at once.
     */
    public void setBurstMillis(long millis) {
        burstNanos = millis * 1_000_000;
    }

    /** Waits for the delay that the link gives a request. */
    public void delay() {
        long end = System.nanoTime() + delayMillis * 1_000_000;
        long left;
        while ((left = end - System.nanoTime()) > 0) LockSupport.parkNanos(left);
    }

    /** Bytes to send at a time, so that a change of the rate is felt soon. */
    public int portion() {
        return (int) Math.max(512, Math.min(16384, bytesPerSecond / 100));
    }

    /** Waits until the link has carried so many bytes; a change of the rate is felt at once. */
    public void carry(int bytes) {
        for (int left = bytes; left > 0; ) {
            int piece = (int) Math.min(left, Math.max(1, Math.min(bytesPerSecond / 100, 1 << 20)));
            carryPiece(piece);
            left -= piece;
        }
    }

    private void carryPiece(int bytes) {
        long until;
        int change;
        synchronized (this) {
            long now = System.nanoTime();
            freeNanos = Math.max(freeNanos, now - burstNanos) + (long) (bytes / bytesPerSecond * 1e9);
            until = freeNanos;
            change = changes.get();
        }
        long left;
        while ((left = until - System.nanoTime()) > 0 && change == changes.get())
            LockSupport.parkNanos(Math.min(left, 10_000_000));
    }
}
