package org.jsmesh.servlet;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.bucket.SiteStore;

/** What the servlet answers about: models of a folder, or of a site in a store of objects. Thread-safe. */
interface Models {
    /** Null when there is no such model; what is found may turn out not to be there. */
    AskedModel find(String id) throws IOException;

    /**
     * A page of the catalogue.
     *
     * @param name of the file, {@code index.json} for the first page
     * @return completes with null when there is none; exceptionally with a
     *     {@link org.jsmesh.store.ModelUnavailableException}
     */
    CompletableFuture<CataloguePage> catalogue(String name) throws IOException;

    /** @param isImmutable whether the address will never have other content */
    record CataloguePage(Document document, boolean isImmutable) {}

    static Models of(ModelSource source) {
        if (source instanceof ModelStore store) return new FolderModels(store);
        if (source instanceof SiteStore site) return new SiteModels(site);
        throw new IllegalArgumentException("models are served from a ModelStore or a SiteStore, not " + source);
    }
}
