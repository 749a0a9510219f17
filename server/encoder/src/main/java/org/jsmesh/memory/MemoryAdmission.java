package org.jsmesh.memory;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/**
 * A gate before work that needs memory: as much enters as fits at the same time. Who came first enters first, so a
 * large piece of work does not wait for ever behind small ones. Work that is larger than the whole runs alone.
 *
 * <pre>
 *     MemoryAdmission gate = MemoryAdmission.ofHeap();
 *     try (MemoryAdmission.Admission room = gate.admit(MemoryEstimate.of(model, settings).bytes())) {
 *         encoding.write(model, archive, ProgressListener.NONE);
 *     }
 * </pre>
 *
 * It counts what its users claim and measures nothing. Thread-safe.
 */
public final class MemoryAdmission {
    private static final double USED = .95;

    private final long capacity;
    private final ReentrantLock lock = new ReentrantLock();
    private final Deque<Condition> waiting = new ArrayDeque<>();
    private long taken;
    private int inside;

    /** Room in the gate. It is given back once, by whichever thread. */
    public final class Admission implements AutoCloseable {
        private final long bytes;
        private boolean closed;

        private Admission(long bytes) {
            this.bytes = bytes;
        }

        /** {@return what it takes of the gate's room, at most all of it} */
        public long bytes() {
            return bytes;
        }

        /** {@return whether nobody else can be inside} */
        public boolean isAlone() {
            return bytes == capacity;
        }

        /** Gives the room back; further calls do nothing. */
        @Override
        public void close() {
            lock.lock();
            try {
                if (closed) return;
                closed = true;
                taken -= bytes;
                inside--;
                wakeFirst();
            } finally {
                lock.unlock();
            }
        }
    }

    /**
     * Makes a gate.
     *
     * @param capacity the bytes that all who are inside may claim together, at least 1
     */
    public MemoryAdmission(long capacity) {
        if (capacity < 1) throw new IllegalArgumentException("bytes of a gate: " + capacity);
        this.capacity = capacity;
    }

    /** {@return a gate for the heap of this process, less a twentieth} */
    public static MemoryAdmission ofHeap() {
        return new MemoryAdmission((long) (USED * Runtime.getRuntime().maxMemory()));
    }

    /** {@return the bytes that all who are inside may claim together} */
    public long capacity() {
        return capacity;
    }

    /** {@return the bytes that those who are inside claim now} */
    public long taken() {
        lock.lock();
        try {
            return taken;
        } finally {
            lock.unlock();
        }
    }

    /** {@return how many are inside now} */
    public int inside() {
        lock.lock();
        try {
            return inside;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Waits for room behind all who wait already.
     *
     * @param bytes that the work needs, not negative; more than the capacity waits until nobody is inside
     * @return the room, to be closed when the work is done
     * @throws InterruptedException when the thread is interrupted while it waits
     */
    public Admission admit(long bytes) throws InterruptedException {
        return admit(bytes, Long.MAX_VALUE);
    }

    /**
     * Waits for room, but not for ever.
     *
     * @param bytes that the work needs, not negative
     * @param millis to wait at most; 0 enters at once or not at all
     * @return the room, or null when there was none in time
     * @throws InterruptedException when the thread is interrupted while it waits
     */
    public Admission admit(long bytes, long millis) throws InterruptedException {
        if (bytes < 0) throw new IllegalArgumentException("bytes of the work: " + bytes);
        long claim = Math.min(bytes, capacity);
        long left = TimeUnit.MILLISECONDS.toNanos(millis);
        lock.lockInterruptibly();
        try {
            if (waiting.isEmpty() && fits(claim)) return enter(claim);
            if (millis <= 0) return null;
            Condition turn = lock.newCondition();
            waiting.add(turn);
            try {
                while (waiting.peek() != turn || !fits(claim)) {
                    if (left <= 0) return null;
                    left = turn.awaitNanos(left);
                }
                return enter(claim);
            } finally {
                waiting.remove(turn);
                wakeFirst();
            }
        } finally {
            lock.unlock();
        }
    }

    /**
     * Waits until nobody is inside, and keeps all others out.
     *
     * @return the whole room
     * @throws InterruptedException when the thread is interrupted while it waits
     */
    public Admission admitAlone() throws InterruptedException {
        return admit(capacity);
    }

    private boolean fits(long claim) {
        return claim <= capacity - taken;
    }

    private Admission enter(long claim) {
        taken += claim;
        inside++;
        return new Admission(claim);
    }

    private void wakeFirst() {
        Condition first = waiting.peek();
        if (first != null) first.signal();
    }
}
