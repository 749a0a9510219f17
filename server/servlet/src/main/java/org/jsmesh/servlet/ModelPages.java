package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.ModelUnavailableException;

/**
 * The pages of single models. An archive that is kept is waited for, because it has the poster; one that must be
 * encoded first is not, and the page then comes without. No thread waits.
 */
final class ModelPages {
    private static final long PATIENCE_MILLIS = 500;

    private final ServletSettings settings;
    private final Waits waits;

    ModelPages(ServletSettings settings, Waits waits) {
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

    void serve(HttpServletRequest request, HttpServletResponse response, ResourcePath resource, AskedModel model)
            throws IOException {
        if (resource.kind() == ResourcePath.Kind.PAGE) send(request, response, model);
        else Answer.redirect(response, 308, SignedAddresses.address(request, model.segment() + "/"));
    }

    private void send(HttpServletRequest request, HttpServletResponse response, AskedModel model) throws IOException {
        AskedModel.Look look = null;
        try {
            CompletableFuture<AskedModel.Look> future = model.look(ClientName.of(request));
            if (!future.isDone() && waits.begin(request, future, model.isOpening(), PATIENCE_MILLIS)) return;
            look = future.isDone() ? future.join() : null;
        } catch (ModelUnavailableException | CompletionException e) {
            boolean isGone = e.getCause() instanceof ModelUnavailableException cause && cause.isGone();
            if (isGone) {
                ModelRequests.unavailable(request, response, (ModelUnavailableException) e.getCause());
                return;
            }
            // The page's script tells why, in words for its visitor.
        }
        String made = look == null ? nameOf(model) : new String(look.manifest(), StandardCharsets.UTF_8);
        String manifest = SignedAddresses.ofPage(request, made);
        byte[] poster = look == null ? null : look.poster();
        String html = settings.template().page(model.segment(), manifest, poster, root(request));
        settings.template().headers().forEach(response::setHeader);
        Document.of("text/html; charset=utf-8", html.getBytes(StandardCharsets.UTF_8))
                .send(request, response, SignedAddresses.caching(request, "no-cache"));
    }

    private static String nameOf(AskedModel model) throws IOException {
        CompletableFuture<String> name = model.name();
        boolean isKnown = name.isDone() && !name.isCompletedExceptionally();
        return Answer.JSON
                .createObjectNode()
                .put("id", model.id())
                .put("name", isKnown ? name.join() : model.id())
                .toString();
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
