package org.jsmesh.store.bucket;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/** A store that can be made to fail or to hang, and counts what it is asked. */
public final class FaultyStore implements ObjectStore {
    public final AtomicInteger lists = new AtomicInteger();
    public final AtomicInteger finds = new AtomicInteger();
    public final AtomicInteger reads = new AtomicInteger();

    private final ObjectStore store;
    /** What every read of bytes does beside. */
    public volatile Runnable besideReading = () -> {};

    private volatile IOException failure;
    private volatile CountDownLatch hold;
    private volatile int readsBeforeFailure = Integer.MAX_VALUE;

    public FaultyStore(ObjectStore store) {
        this.store = store;
    }

    /** Everything fails from now on; nothing any more for null. */
    public void fail(IOException reason) {
        failure = reason;
    }

    /** Reading fails after so many times more. */
    public void failAfter(int count) {
        readsBeforeFailure = reads.get() + count;
    }

    /** Nothing is answered from now on. */
    public void hang() {
        hold = new CountDownLatch(1);
    }

    /** All that hangs goes on. */
    public void release() {
        CountDownLatch held = hold;
        hold = null;
        if (held != null) held.countDown();
    }

    /** Answers come again, but those who wait for one wait on. */
    public void recover() {
        hold = null;
    }

    private void ask() throws IOException {
        CountDownLatch held = hold;
        try {
            if (held != null) held.await();
        } catch (InterruptedException e) {
            throw new IOException("interrupted", e);
        }
        IOException reason = failure;
        if (reason != null) throw reason;
    }

    @Override
    public String address() {
        return "s3://faulty/site";
    }

    @Override
    public Optional<StoredObject> find(String key) throws IOException {
        finds.incrementAndGet();
        ask();
        return store.find(key);
    }

    @Override
    public InputStream open(String key) throws IOException {
        ask();
        return store.open(key);
    }

    @Override
    public void read(StoredObject object, long offset, ByteBuffer into) throws IOException {
        ask();
        if (reads.incrementAndGet() > readsBeforeFailure) throw new IOException("the service answers 503 SlowDown");
        besideReading.run();
        store.read(object, offset, into);
    }

    @Override
    public StoredObject put(Upload upload) throws IOException {
        return store.put(upload);
    }

    @Override
    public void delete(String key) throws IOException {
        store.delete(key);
    }

    @Override
    public void list(String prefix, String after, Visitor visitor) throws IOException {
        lists.incrementAndGet();
        store.list(prefix, after, visitor);
    }

    @Override
    public Optional<URI> signedAddress(String key, Duration lifetime) {
        return Optional.of(URI.create("https://bucket.example/site/" + key + "?lifetime=" + lifetime.toSeconds()));
    }

    @Override
    public void close() throws IOException {
        release();
        store.close();
    }
}
