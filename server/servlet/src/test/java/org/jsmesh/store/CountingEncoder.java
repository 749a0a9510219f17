package org.jsmesh.store;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.files.FolderResources;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.ModelEncoder;
import org.jsmesh.test.Await;

/**
 * Makes test archives of model files whose text is a seed, counts how often, and refuses files that say {@code bad}.
 * While it is held it begins encodings but ends none that is not cancelled.
 */
public final class CountingEncoder implements ModelEncoder {
    private final AtomicInteger begun = new AtomicInteger();
    private final AtomicInteger running = new AtomicInteger();
    private volatile List<String> companions = List.of();
    private volatile CountDownLatch gate = new CountDownLatch(0);

    @Override
    public ModelInputs encode(Path model, Path archive, ProgressListener progress) throws IOException {
        begun.incrementAndGet();
        running.incrementAndGet();
        try {
            Await.until("the test to let the encoder go on", () -> {
                progress.step("simplifying", 0.5);
                return gate.await(10, TimeUnit.MILLISECONDS);
            });
            byte[] content = Files.readAllBytes(model);
            ModelInputs inputs = new ModelInputs();
            inputs.model(content);
            for (String companion : companions)
                inputs.noting(new FolderResources(model.getParent())).find(companion);
            String text = new String(content, StandardCharsets.UTF_8);
            if (text.equals("bad")) throw new IllegalArgumentException("the mesh has no face");
            if (text.equals("broken")) throw new IllegalStateException("a mistake in the encoder");
            Files.write(archive, archiveOf(text));
            return inputs;
        } catch (IOException | RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IOException(e);
        } finally {
            running.decrementAndGet();
        }
    }

    /** What a model file with that text becomes. */
    public static byte[] archiveOf(String text) {
        return TestArchives.of(text.hashCode(), 600, 1000, 2000, 3000);
    }

    /** From now on every model refers to these files. */
    public void referTo(String... paths) {
        companions = List.of(paths);
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
