package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;

/**
 * Makes test archives of model files whose text is a seed, counts how often, and refuses files that say {@code bad}.
 * While it is held it begins encodings but does not end them.
 */
public final class CountingEncoder implements ModelEncoder {
    private final AtomicInteger begun = new AtomicInteger();
    private final AtomicInteger running = new AtomicInteger();
    private volatile CountDownLatch gate = new CountDownLatch(0);

    @Override
    public byte[] encode(Path model, ProgressListener progress) throws IOException {
        begun.incrementAndGet();
        running.incrementAndGet();
        try {
            Await.open("the test to let the encoder go on", gate);
            progress.step("simplifying", 0.5);
            String text = Files.readString(model);
            if (text.equals("bad")) throw new IllegalArgumentException("the mesh has no face");
            if (text.equals("broken")) throw new IllegalStateException("a mistake in the encoder");
            return archiveOf(text);
        } catch (InterruptedException e) {
            throw new IOException(e);
        } finally {
            running.decrementAndGet();
        }
    }

    /** What a model file with that text becomes. */
    public static byte[] archiveOf(String text) {
        return TestArchives.of(text.hashCode(), 600, 1000, 2000, 3000);
    }

    public void hold() {
        gate = new CountDownLatch(1);
    }

    public void release() {
        gate.countDown();
    }

    /** Waits until so many encodings run at the same time. */
    public void awaitRunning(int count) throws Exception {
        Await.until(count + " encodings at a time", () -> running.get() >= count);
    }

    public int begun() {
        return begun.get();
    }
}
