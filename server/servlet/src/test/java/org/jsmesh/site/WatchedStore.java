package org.jsmesh.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/** A folder that is taken for a bucket, in which others do something at certain times. Not thread-safe. */
final class WatchedStore implements ObjectStore {
    /** What is there, for what others do. */
    final ObjectStore inner;

    private final List<String> log = new ArrayList<>();
    private final Map<String, Act> acts = new HashMap<>();

    WatchedStore(Path folder) {
        inner = new FolderObjectStore(folder);
    }

    /** What others do. */
    interface Act {
        void run() throws IOException;
    }

    /** Does something once, just before something is asked: {@code put m/index.json}. */
    void before(String request, Act act) {
        acts.put(request, act);
    }

    /** What was asked, in order. */
    List<String> log() {
        return log;
    }

    private void ask(String what, String key) throws IOException {
        String request = what + " " + key;
        log.add(request);
        Act act = acts.remove(request);
        if (act != null) act.run();
    }

    @Override
    public String address() {
        return inner.address();
    }

    @Override
    public Optional<StoredObject> find(String key) throws IOException {
        ask("find", key);
        return inner.find(key);
    }

    @Override
    public InputStream open(String key) throws IOException {
        ask("open", key);
        return inner.open(key);
    }

    @Override
    public void read(StoredObject object, long offset, ByteBuffer into) throws IOException {
        ask("read", object.key());
        inner.read(object, offset, into);
    }

    @Override
    public StoredObject put(Upload upload) throws IOException {
        ask("put", upload.key());
        return inner.put(upload);
    }

    @Override
    public void delete(String key) throws IOException {
        ask("delete", key);
        inner.delete(key);
    }

    @Override
    public void list(String prefix, String after, Visitor visitor) throws IOException {
        ask("list", prefix);
        inner.list(prefix, after, visitor);
    }

    @Override
    public void close() throws IOException {
        inner.close();
    }
}
