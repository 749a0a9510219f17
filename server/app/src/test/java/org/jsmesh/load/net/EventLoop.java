package org.jsmesh.load.net;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.CancelledKeyException;
import java.nio.channels.SelectableChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.PriorityQueue;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * One thread that reads and writes many sockets without blocking, and does things at their times. All callbacks run on
 * it; only {@link #submit} may be called from elsewhere.
 */
public final class EventLoop implements AutoCloseable {
    private static final int BUFFER_BYTES = 1 << 18;

    private final Selector selector;
    private final Thread thread;
    private final PriorityQueue<Timer> timers = new PriorityQueue<>();
    private final Queue<Runnable> submitted = new ConcurrentLinkedQueue<>();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_BYTES);
    private long timerCount;
    private volatile boolean closed;
    private volatile Throwable failure;
    private volatile double worstLagMillis;

    /** Told when its socket can be read or written. */
    public interface Handler {
        void ready(SelectionKey key);
    }

    /** Something to do at a time. */
    public static final class Timer implements Comparable<Timer> {
        private final double atMillis;
        private final long number;
        private Runnable task;

        private Timer(double atMillis, long number, Runnable task) {
            this.atMillis = atMillis;
            this.number = number;
            this.task = task;
        }

        public void cancel() {
            task = null;
        }

        @Override
        public int compareTo(Timer o) {
            int c = Double.compare(atMillis, o.atMillis);
            return c != 0 ? c : Long.compare(number, o.number);
        }

        @Override
        public boolean equals(Object o) {
            return this == o;
        }

        @Override
        public int hashCode() {
            return Long.hashCode(number);
        }
    }

    public EventLoop(String name) throws IOException {
        selector = Selector.open();
        thread = new Thread(this::run, name);
        thread.setDaemon(true);
        thread.start();
    }

    /** The clock of every loop. */
    public static double millis() {
        return System.nanoTime() / 1e6;
    }

    /** Runs a task on the loop. */
    public void submit(Runnable task) {
        submitted.add(task);
        selector.wakeup();
    }

    public Timer at(double millis, Runnable task) {
        Timer timer = new Timer(millis, timerCount++, task);
        timers.add(timer);
        return timer;
    }

    public SelectionKey register(SelectableChannel channel, int operations, Handler handler) throws IOException {
        return channel.register(selector, operations, handler);
    }

    /** A buffer for the callback that runs; cleared. */
    ByteBuffer buffer() {
        return buffer.clear();
    }

    /** Why the loop ended before its time, or null. */
    public Throwable failure() {
        return failure;
    }

    /** The latest that a task ran after its time, since this was asked last. */
    public double worstLagMillis() {
        double worst = worstLagMillis;
        worstLagMillis = 0;
        return worst;
    }

    private void run() {
        try {
            while (!closed) {
                select();
                for (Runnable task; (task = submitted.poll()) != null; ) task.run();
                runTimers();
            }
        } catch (IOException | RuntimeException | Error e) {
            failure = e;
        } finally {
            closeAll();
        }
    }

    private void select() throws IOException {
        Timer next = timers.peek();
        double left = next == null ? 1000 : next.atMillis - millis();
        Select how = key -> {
            try {
                ((Handler) key.attachment()).ready(key);
            } catch (CancelledKeyException e) {
                // its socket was closed by a callback before
            }
        };
        // Waiting takes whole milliseconds: rounded up, so that the last one is not spent in a busy loop.
        if (left <= 0) selector.selectNow(how::ready);
        else selector.select(how::ready, (long) Math.ceil(Math.min(left, 1000)));
    }

    private interface Select {
        void ready(SelectionKey key);
    }

    private void runTimers() {
        while (!timers.isEmpty()) {
            double now = millis();
            Timer first = timers.peek();
            if (first.atMillis > now) return;
            timers.poll();
            Runnable task = first.task;
            if (task == null) continue;
            if (now - first.atMillis > worstLagMillis) worstLagMillis = now - first.atMillis;
            task.run();
        }
    }

    private void closeAll() {
        for (SelectionKey key : selector.keys()) closeQuietly(key.channel());
        closeQuietly(selector);
    }

    public static void closeQuietly(AutoCloseable closeable) {
        if (closeable == null) return;
        try {
            closeable.close();
        } catch (Exception e) {
            // it is gone either way
        }
    }

    @Override
    public void close() {
        closed = true;
        selector.wakeup();
        try {
            thread.join(10_000);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (failure instanceof IOException io) throw new UncheckedIOException(io);
        if (failure != null) throw new IllegalStateException("the loop failed", failure);
    }
}
