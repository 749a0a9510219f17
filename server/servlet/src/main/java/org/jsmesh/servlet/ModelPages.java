package org.jsmesh.servlet;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ModelUnavailableException;

/**
 * The pages of single models. An archive that is kept is waited for, because it has the poster; one that must be
 * encoded first is not, and the page then comes without. No thread waits.
 */
final class ModelPages {
    private static final String WAITED = ModelPages.class.getName() + ".waited";
    private static final long PATIENCE_MILLIS = 500;

    private final ModelStore store;
    private final ServletSettings settings;

    ModelPages(ModelStore store, ServletSettings settings) {
        this.store = store;
        this.settings = settings;
    }

    void send(HttpServletRequest request, HttpServletResponse response, ModelEntry entry) throws IOException {
        Archive archive = null;
        try {
            CompletableFuture<Archive> future = store.archive(entry);
            if (future.isDone()) {
                archive = future.isCompletedExceptionally() ? null : future.join();
            } else if (request.getAttribute(WAITED) == null) {
                request.setAttribute(WAITED, true);
                comeBack(request, future);
                return;
            }
        } catch (ModelUnavailableException e) {
            // The page's script tells why, in words for its visitor.
        }
        String manifest = archive == null ? nameOf(entry) : ManifestJson.of(entry, archive);
        String html = settings.template().page(entry.segment(), manifest, poster(archive), root(request));
        settings.template().headers().forEach(response::setHeader);
        Document.of("text/html; charset=utf-8", html.getBytes(StandardCharsets.UTF_8))
                .send(request, response, "no-cache");
    }

    private static void comeBack(HttpServletRequest request, CompletableFuture<Archive> future) {
        AsyncContext async = request.startAsync();
        async.setTimeout(0);
        future.copy()
                .orTimeout(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)
                .whenComplete((archive, late) -> async.dispatch());
    }

    private static String nameOf(ModelEntry entry) {
        return Answer.JSON
                .createObjectNode()
                .put("id", entry.id())
                .put("name", entry.name())
                .toString();
    }

    private static byte[] poster(Archive archive) {
        int batch = archive == null ? -1 : archive.batches().poster();
        if (batch < 0) return null;
        BatchIndex index = archive.batches();
        return archive.copy(index.offset(batch), BatchIndex.payloadBytes(index.bytes(batch)));
    }

    private String root(HttpServletRequest request) {
        if (settings.publicUrl() != null) return settings.publicUrl();
        try {
            return URI.create(request.getRequestURL().toString())
                    .resolve("../../")
                    .toString();
        } catch (IllegalArgumentException e) {
            return null; // the client named a host that is none
        }
    }
}
