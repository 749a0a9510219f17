package org.jsmesh.memory;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.BooleanSupplier;

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
    private static final long LOOK_NANOS = 100_000_000;

    private final long capacity;
    private final ReentrantLock lock = new ReentrantLock();
    private final Deque<Condition> waiting = new ArrayDeque<>();
    private long taken;
    private final List<Admission> inside = new ArrayList<>();

    /** Room in the gate. It is given back once, by whichever thread. */
    public final class Admission implements AutoCloseable {
        private final long bytes;
        private boolean hadCompany;
        private boolean closed;

        private Admission(long bytes) {
            this.bytes = bytes;
        }

        /** {@return what it takes of the gate's room, at most all of it} */
        public long bytes() {
            return bytes;
        }

        /** {@return whether nobody else has been inside since it was given} */
        public boolean isAlone() {
            lock.lock();
            try {
                return !hadCompany;
            } finally {
                lock.unlock();
            }
        }

        /** Gives the room back; further calls do nothing. */
        @Override
        public void close() {
            lock.lock();
            try {
                if (closed) return;
                closed = true;
                taken -= bytes;
                inside.remove(this);
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
            return inside.size();
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
        return admit(bytes, () -> false, Long.MAX_VALUE);
    }

    /**
     * Waits for room until it is not wanted any more.
     *
     * @param bytes that the work needs, not negative
     * @param isCancelled is asked some times a second, with the gate held: it must answer at once
     * @return the room, or null when it was cancelled before there was some
     * @throws InterruptedException when the thread is interrupted while it waits
     */
    public Admission admit(long bytes, BooleanSupplier isCancelled) throws InterruptedException {
        return admit(bytes, isCancelled, Long.MAX_VALUE);
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
        return admit(bytes, () -> false, TimeUnit.MILLISECONDS.toNanos(millis));
    }

    private Admission admit(long bytes, BooleanSupplier isCancelled, long nanos) throws InterruptedException {
        if (bytes < 0) throw new IllegalArgumentException("bytes of the work: " + bytes);
        long claim = Math.min(bytes, capacity);
        lock.lockInterruptibly();
        try {
            if (waiting.isEmpty() && fits(claim)) return enter(claim);
            Condition turn = lock.newCondition();
            waiting.add(turn);
            try {
                for (long left = nanos; waiting.peek() != turn || !fits(claim); ) {
                    if (left <= 0 || isCancelled.getAsBoolean()) return null;
                    long look = Math.min(left, LOOK_NANOS);
                    left -= look - turn.awaitNanos(look);
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
        Admission room = new Admission(claim);
        inside.add(room);
        if (inside.size() > 1) for (Admission other : inside) other.hadCompany = true;
        return room;
    }

    private void wakeFirst() {
        Condition first = waiting.peek();
        if (first != null) first.signal();
    }
}
