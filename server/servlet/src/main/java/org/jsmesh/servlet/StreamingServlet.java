package org.jsmesh.servlet;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ModelUnavailableException;

/**
 * The resources of the protocol below {@code /m/}: catalogue, manifest, archive, batches and patches. Ids are looked up in the store and never
 * become paths. A request for a model that is still being encoded waits without holding a thread. {@code docs/protocol.md} describes all.
 */
public final class StreamingServlet extends HttpServlet {
    private static final long serialVersionUID = 1L;
    private static final Logger LOG = System.getLogger(StreamingServlet.class.getName());
    private static final String ARRIVED = StreamingServlet.class.getName() + ".arrived";
    private static final String RETRY_SECONDS = "5";
    private static final Pattern RESOURCE = Pattern.compile(
            "/(?<id>[a-z0-9-]+)/(?:(?<manifest>manifest\\.json)|(?<sha>[0-9a-f]{64})(?:(?<archive>\\.jsm)|/(?<patches>patches)"
                    + "|/batches/(?<first>0|[1-9]\\d{0,8})-(?<last>0|[1-9]\\d{0,8})))");

    private final transient ModelStore store;

    public StreamingServlet(ModelStore store) {
        this.store = store;
    }

    @Override
    protected void service(HttpServletRequest request, HttpServletResponse response) throws IOException {
        if (request.getAttribute(ARRIVED) == null) request.setAttribute(ARRIVED, System.nanoTime());
        try {
            allowOtherOrigins(response);
            switch (request.getMethod()) {
                case "GET", "HEAD" -> route(request, response);
                case "OPTIONS" -> preflight(response);
                default -> Answer.methodNotAllowed(request, response);
            }
        } catch (IOException | RuntimeException e) {
            if (response.isCommitted()) throw e;
            LOG.log(Level.ERROR, "Cannot answer " + request.getRequestURI(), e);
            int status = HttpServletResponse.SC_INTERNAL_SERVER_ERROR;
            Answer.error(request, response, status, "the server failed to answer", "see the server's log");
        }
    }

    /** Archives are public data, meant to be shown by pages from anywhere and measured by them. */
    private static void allowOtherOrigins(HttpServletResponse response) {
        response.setHeader("Access-Control-Allow-Origin", "*");
        response.setHeader(
                "Access-Control-Expose-Headers",
                "Accept-Ranges, Content-Length, Content-Location, Content-Range, ETag, Server-Timing");
        response.setHeader("Cross-Origin-Resource-Policy", "cross-origin");
        response.setHeader("Timing-Allow-Origin", "*");
    }

    private static void preflight(HttpServletResponse response) {
        response.setHeader("Allow", Answer.METHODS);
        response.setHeader("Access-Control-Allow-Methods", Answer.METHODS);
        response.setHeader("Access-Control-Allow-Headers", "Range, If-Range, If-None-Match");
        response.setHeader("Access-Control-Max-Age", "86400");
        response.setStatus(HttpServletResponse.SC_NO_CONTENT);
    }

    private void route(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String path = request.getPathInfo();
        if (path == null) {
            String folder = request.getServletPath();
            Answer.redirect(response, 308, folder.substring(folder.lastIndexOf('/') + 1) + "/");
        } else if (path.equals("/")) {
            catalogue(request, response, wantsPage(request.getHeader("Accept")));
        } else if (path.equals("/index.json")) {
            catalogue(request, response, false);
        } else {
            Matcher resource = RESOURCE.matcher(path);
            Optional<ModelEntry> entry = resource.matches() ? store.find(resource.group("id")) : Optional.empty();
            if (entry.isPresent()) serve(request, response, resource, entry.get());
            else
                notFound(
                        request,
                        response,
                        "there is no such model or resource",
                        "see the catalogue at /m/ for what there is");
        }
    }

    private void catalogue(HttpServletRequest request, HttpServletResponse response, boolean page) throws IOException {
        response.setHeader("Vary", "Accept");
        response.setHeader("Cache-Control", "no-cache");
        if (page) Answer.redirect(response, HttpServletResponse.SC_SEE_OTHER, "../");
        else Answer.json(request, response, HttpServletResponse.SC_OK, Catalogue.json(store.list()));
    }

    private static boolean wantsPage(String accept) {
        String types = accept == null ? "" : accept.toLowerCase(Locale.ROOT);
        return types.contains("text/html") && !types.contains("application/json");
    }

    private void serve(HttpServletRequest request, HttpServletResponse response, Matcher resource, ModelEntry entry)
            throws IOException {
        try {
            CompletableFuture<Archive> future = store.archive(entry);
            if (!future.isDone()) {
                awaitAndComeBack(request, future);
                return;
            }
            Archive archive = future.join();
            long nanos = System.nanoTime() - (Long) request.getAttribute(ARRIVED);
            response.setHeader("Server-Timing", String.format(Locale.ROOT, "prepare;dur=%.3f", nanos / 1e6));
            if (resource.group("manifest") != null) Manifest.send(request, response, entry, archive);
            else sendBytes(request, response, resource, archive);
        } catch (ModelUnavailableException e) {
            unavailable(request, response, e);
        } catch (CompletionException e) {
            unavailable(request, response, (ModelUnavailableException) e.getCause());
        }
    }

    private static void awaitAndComeBack(HttpServletRequest request, CompletableFuture<Archive> future) {
        AsyncContext async = request.startAsync();
        // An encoding always ends, and a large one takes longer than any container's default.
        async.setTimeout(0);
        future.whenComplete((archive, failure) -> async.dispatch());
    }

    private static void sendBytes(
            HttpServletRequest request, HttpServletResponse response, Matcher resource, Archive archive)
            throws IOException {
        if (!resource.group("sha").equals(archive.sha256())) {
            String reason = "the archive of this model is another one by now: " + archive.sha256();
            notFound(request, response, reason, "read the model's manifest.json again and start from the beginning");
        } else if (resource.group("archive") != null) {
            ArchiveBytes.sendArchive(request, response, archive);
        } else if (resource.group("patches") != null) {
            Patches.send(request, response, archive);
        } else {
            int first = Integer.parseInt(resource.group("first"));
            int last = Integer.parseInt(resource.group("last"));
            int count = archive.batches().size();
            if (first <= last && last < count) ArchiveBytes.sendBatches(request, response, archive, first, last);
            else
                notFound(
                        request,
                        response,
                        "the archive has the batches 0 to " + (count - 1),
                        "ask for batches that exist");
        }
    }

    private static void unavailable(
            HttpServletRequest request, HttpServletResponse response, ModelUnavailableException e) throws IOException {
        if (e.isPassing()) response.setHeader("Retry-After", RETRY_SECONDS);
        int status = e.isPassing() ? HttpServletResponse.SC_SERVICE_UNAVAILABLE : 422;
        Answer.error(request, response, status, e.getMessage(), e.remedy());
    }

    private static void notFound(HttpServletRequest request, HttpServletResponse response, String reason, String remedy)
            throws IOException {
        Answer.error(request, response, HttpServletResponse.SC_NOT_FOUND, reason, remedy);
    }
}
