package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.sandbox.ModelEncoder;

/** Stores that take test archives for archives. */
public final class TestStores {
    private TestStores() {}

    public static ModelStore open(Path source, Path cache, ModelEncoder encoder) throws IOException {
        return new ModelStore(settings(source, cache), encoder, TestArchives.READER);
    }

    public static ModelStore open(StoreSettings settings, ModelEncoder encoder) throws IOException {
        return new ModelStore(settings, encoder, TestArchives.READER);
    }

    public static StoreSettings settings(Path source, Path cache) {
        return StoreSettings.of(source).withCache(cache).withEncoders(2);
    }
}
