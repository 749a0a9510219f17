package org.jsmesh.s3;

import java.io.IOException;
import java.time.Duration;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStoreProvider;

/** Opens {@code s3://bucket/prefix}. */
public final class S3ObjectStoreProvider implements ObjectStoreProvider {
    /** For {@link java.util.ServiceLoader}. */
    public S3ObjectStoreProvider() {}

    @Override
    public String scheme() {
        return "s3";
    }

    @Override
    public ObjectStore open(String address) throws IOException {
        return S3ObjectStore.at(address);
    }

    @Override
    public ObjectStore open(String address, Duration patience) throws IOException {
        return S3ObjectStore.at(address, patience);
    }
}
