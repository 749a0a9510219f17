package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.ModelUnavailableException;

/** The pages of the catalogue. */
final class CatalogueRequests {
    static final String FIRST = "index.json";

    private final Models models;
    private final Waits waits;

    CatalogueRequests(Models models, Waits waits) {
        this.models = models;
        this.waits = waits;
    }

    /** Whether a path can be that of a page. No id of a model has a dot. */
    static boolean isPage(String path) {
        return path.endsWith(".json") && path.indexOf('/', 1) < 0;
    }

    /** @param name of the page's file */
    void send(HttpServletRequest request, HttpServletResponse response, String name) throws IOException {
        CompletableFuture<Models.CataloguePage> asked = models.catalogue(name);
        if (!asked.isDone() && waits.begin(request, asked, true, Waits.MILLIS)) return;
        if (!asked.isDone()) {
            response.setHeader("Retry-After", "1");
            int status = HttpServletResponse.SC_SERVICE_UNAVAILABLE;
            Answer.error(request, response, status, "the catalogue is still being read", "ask again later");
            return;
        }
        Models.CataloguePage page;
        try {
            page = asked.join();
        } catch (CompletionException e) {
            ModelRequests.unavailable(request, response, (ModelUnavailableException) e.getCause());
            return;
        }
        if (page == null) {
            notFound(request, response);
            return;
        }
        String caching = page.isImmutable() ? ArchiveResponse.IMMUTABLE : "no-cache";
        SignedAddresses.document(request, page.document())
                .send(request, response, SignedAddresses.caching(request, caching));
    }

    /** Tells that there is nothing under an address. */
    static void notFound(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String remedy = "see the catalogue, index.json, for what there is";
        int status = HttpServletResponse.SC_NOT_FOUND;
        Answer.error(request, response, status, "there is no such model or resource", remedy);
    }
}
