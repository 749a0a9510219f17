package org.jsmesh.store;

import java.io.IOException;
import java.nio.file.Path;

/** Stores that take test archives for archives. */
public final class TestStores {
    private TestStores() {}

    public static ModelStore open(Path source, Path cache, ModelEncoder encoder) throws IOException {
        return new ModelStore(new StoreSettings(source, cache, 2), encoder, TestArchives.READER);
    }
}
