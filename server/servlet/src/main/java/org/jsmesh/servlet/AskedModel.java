package org.jsmesh.servlet;

import java.io.IOException;
import java.net.URI;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.store.ServedArchive;
import org.jsmesh.store.ids.ModelIds;

/**
 * A model that a request asks for. What takes time comes by futures, which complete exceptionally with
 * {@link ModelUnavailableException} alone. A request that has waited asks anew, and gets what is there by then.
 */
interface AskedModel {
    String id();

    /** The id as a part of an address. */
    default String segment() {
        return ModelIds.segment(id());
    }

    /** Its name for people. */
    CompletableFuture<String> name() throws IOException;

    /** The manifest as JSON. */
    CompletableFuture<byte[]> manifest(String client) throws ModelUnavailableException;

    /**
     * Its archive.
     *
     * @param sha256 of the one that is asked for; another one may come
     */
    CompletableFuture<? extends ServedArchive> archive(String client, String sha256) throws ModelUnavailableException;

    /** The same if it is there already; otherwise null. */
    ServedArchive recent(String sha256);

    /** The manifest, and the poster where there is one. */
    CompletableFuture<Look> look(String client) throws ModelUnavailableException;

    /** @param poster a JPEG, or null */
    record Look(byte[] manifest, byte[] poster) {}

    /** What people wrote about it; null in it when there is nothing. */
    CompletableFuture<byte[]> annotations() throws IOException;

    /** Where else the bytes of its archive are; null to send them. */
    URI elsewhere(String sha256);

    /** Whether what is waited for is there, and is only opened. */
    boolean isOpening();

    /** What is being done, and how far that is. */
    Progress progress();

    /** @param fraction 0 to 1 */
    record Progress(String stage, double fraction) {}
}
