package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
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
    private static final long PATIENCE_MILLIS = 500;

    private final ModelStore store;
    private final ServletSettings settings;
    private final Waits waits;

    ModelPages(ModelStore store, ServletSettings settings, Waits waits) {
        this.store = store;
        this.waits = waits;
        this.settings = settings;
    }

    /**
     * Whether a page is asked for, by browsers and by those who show links: by all who do not say that they want JSON.
     */
    boolean isAsked(HttpServletRequest request, HttpServletResponse response, ResourcePath resource) {
        boolean mayBe = resource.kind() == ResourcePath.Kind.PAGE || resource.kind() == ResourcePath.Kind.MODEL;
        if (!mayBe || settings.template() == null) return false;
        response.addHeader("Vary", "Accept");
        String accept = request.getHeader("Accept");
        return accept == null || !accept.toLowerCase(Locale.ROOT).contains("application/json");
    }

    void serve(HttpServletRequest request, HttpServletResponse response, ResourcePath resource, ModelEntry entry)
            throws IOException {
        if (resource.kind() == ResourcePath.Kind.PAGE) send(request, response, entry);
        else Answer.redirect(response, 308, SignedAddresses.address(request, entry.segment() + "/"));
    }

    private void send(HttpServletRequest request, HttpServletResponse response, ModelEntry entry) throws IOException {
        Archive archive = null;
        try {
            CompletableFuture<Archive> future = store.archive(entry, ClientName.of(request));
            if (!future.isDone() && waits.begin(request, future, store.isOpening(entry), PATIENCE_MILLIS)) return;
            archive = future.isDone() && !future.isCompletedExceptionally() ? future.join() : null;
        } catch (ModelUnavailableException e) {
            // The page's script tells why, in words for its visitor.
        }
        String made = archive == null ? nameOf(entry) : ManifestJson.of(entry, archive);
        String manifest = SignedAddresses.ofPage(request, made);
        String html = settings.template().page(entry.segment(), manifest, poster(archive), root(request));
        settings.template().headers().forEach(response::setHeader);
        Document.of("text/html; charset=utf-8", html.getBytes(StandardCharsets.UTF_8))
                .send(request, response, SignedAddresses.caching(request, "no-cache"));
    }

    private static String nameOf(ModelEntry entry) {
        return Answer.JSON
                .createObjectNode()
                .put("id", entry.id())
                .put("name", entry.name())
                .toString();
    }

    private static byte[] poster(Archive archive) throws IOException {
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
