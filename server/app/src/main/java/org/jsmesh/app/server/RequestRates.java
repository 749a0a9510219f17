package org.jsmesh.app.server;

import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;

/**
 * How fast each address may ask: a bucket of {@code burst} requests that fills again at a rate (the generic cell rate
 * algorithm of ATM, ITU-T I.371: a bucket is the one time at which it would be full). However many addresses ask, the
 * memory stays the same: the buckets are a table, and each address has two of them, chosen by a secret. An address is
 * refused when both are empty, so it hardly ever pays for another one that shares one of them. Thread-safe.
 */
final class RequestRates {
    private static final int BUCKETS = 1 << 16;
    private static final long SECOND = 1_000_000_000L;

    private final AtomicLongArray full = new AtomicLongArray(BUCKETS);
    private final LongAdder refused = new LongAdder();
    private final long interval;
    private final long depth;
    private final LongSupplier nanos;
    private final long begin;
    private final long firstSecret;
    private final long secondSecret;

    RequestRates(Limits limits) {
        this(limits, System::nanoTime, new SplittableRandom());
    }

    RequestRates(Limits limits, LongSupplier nanos, SplittableRandom random) {
        interval = limits.requestsPerSecond() == 0 ? 0 : SECOND / limits.requestsPerSecond();
        depth = interval * limits.requestBurst();
        this.nanos = nanos;
        begin = nanos.getAsLong();
        firstSecret = random.nextLong();
        secondSecret = random.nextLong();
    }

    /**
     * Counts a request.
     *
     * @return 0 when it may be answered; otherwise the seconds after which the next one may
     */
    int take(String address) {
        if (interval == 0) return 0;
        long now = nanos.getAsLong() - begin;
        long first = take(place(address, firstSecret), now);
        long second = take(place(address, secondSecret), now);
        long wait = Math.min(first, second);
        if (wait == 0) return 0;
        refused.increment();
        return (int) Math.min(Integer.MAX_VALUE, (wait + SECOND - 1) / SECOND);
    }

    /** Nanoseconds after which there is room for one more; 0 when there was, and it is taken. */
    private long take(int bucket, long now) {
        while (true) {
            long before = full.get(bucket);
            long after = Math.max(before, now) + interval;
            if (after - now > depth) return after - now - depth;
            if (full.compareAndSet(bucket, before, after)) return 0;
        }
    }

    /** Nobody who does not know the secret can choose addresses that share a bucket. */
    private static int place(String address, long secret) {
        long hash = secret;
        for (int i = 0; i < address.length(); i++) hash = mix(hash ^ address.charAt(i));
        return (int) (hash >>> 48) & BUCKETS - 1;
    }

    /** The finalizer of MurmurHash3, which lets every bit change every other. */
    private static long mix(long bits) {
        long mixed = (bits ^ bits >>> 33) * 0xff51afd7ed558ccdL;
        mixed = (mixed ^ mixed >>> 33) * 0xc4ceb9fe1a85ec53L;
        return mixed ^ mixed >>> 33;
    }

    /** Requests that were refused since the start. */
    long refused() {
        return refused.sum();
    }
}
