package org.jsmesh.store;

import java.io.IOException;

/** Where a server has its models from: a {@link ModelStore}, or a {@link org.jsmesh.store.bucket.SiteStore}. */
public interface ModelSource extends AutoCloseable {
    /**
     * Tells whether requests for bytes of a model are answered without waiting for a disk or another machine.
     *
     * @param id any text
     * @return false also when there may be no such model
     */
    boolean isKnown(String id);

    /**
     * Tells whether models can be listed.
     *
     * @throws IOException the reason why not
     */
    void check() throws IOException;

    @Override
    void close();
}
