package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/** Counts what is asked of a store. */
final class CountingStore implements ObjectStore {
    private final ObjectStore store;
    private final Map<String, Integer> counts = new TreeMap<>();
    private long bytesRead;
    private long bytesWritten;

    CountingStore(ObjectStore store) {
        this.store = store;
    }

    private synchronized void count(String what, long read, long written) {
        counts.merge(what, 1, Integer::sum);
        bytesRead += read;
        bytesWritten += written;
    }

    synchronized Map<String, Integer> counts() {
        return new TreeMap<>(counts);
    }

    synchronized long total() {
        return counts.values().stream().mapToInt(Integer::intValue).sum();
    }

    synchronized long bytesRead() {
        return bytesRead;
    }

    synchronized long bytesWritten() {
        return bytesWritten;
    }

    synchronized void reset() {
        counts.clear();
        bytesRead = 0;
        bytesWritten = 0;
    }

    @Override
    public String address() {
        return store.address();
    }

    @Override
    public Optional<StoredObject> find(String key) throws IOException {
        count("find", 0, 0);
        return store.find(key);
    }

    @Override
    public InputStream open(String key) throws IOException {
        count("read", store.find(key).map(StoredObject::bytes).orElse(0L), 0);
        return store.open(key);
    }

    @Override
    public void read(StoredObject object, long offset, ByteBuffer into) throws IOException {
        count("read", into.remaining(), 0);
        store.read(object, offset, into);
    }

    @Override
    public StoredObject put(Upload upload) throws IOException {
        count("put", 0, upload.content().bytes());
        return store.put(upload);
    }

    @Override
    public void delete(String key) throws IOException {
        count("delete", 0, 0);
        store.delete(key);
    }

    @Override
    public void list(String prefix, String after, Visitor visitor) throws IOException {
        count("list", 0, 0);
        store.list(prefix, after, visitor);
    }

    @Override
    public void close() throws IOException {
        store.close();
    }
}
