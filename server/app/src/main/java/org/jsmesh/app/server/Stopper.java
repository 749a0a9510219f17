package org.jsmesh.app.server;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * When the process is told to end (SIGTERM, Ctrl+C), lets the server end what it does, and lets the thread that waits
 * for the server close what it used, before the JVM ends. Close it last.
 */
public final class Stopper implements AutoCloseable {
    private static final long CLOSING_SECONDS = 10;

    private final CountDownLatch closed = new CountDownLatch(1);
    private final Thread hook = new Thread(this::stop, "jsm-stop");
    private JsmServer server;
    private boolean stopping;

    public Stopper() {
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** Waits until the server has stopped, or the process is to end. */
    public void await(JsmServer running) throws InterruptedException {
        synchronized (this) {
            if (stopping) return; // the process was told to end before there was a server
            server = running;
        }
        running.join();
    }

    private void stop() {
        JsmServer running;
        synchronized (this) {
            stopping = true;
            running = server;
        }
        if (running != null) running.close();
        try {
            // The thread that waited for the server now goes on, and closes the store and the log.
            closed.await(CLOSING_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The JVM is ending: the hook runs already, and the rest closes fast enough.
        }
        closed.countDown();
    }
}
