package org.jsmesh.servlet;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.DispatcherType;
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
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ModelUnavailableException;

/**
 * The resources of the protocol below {@code /m/}: catalogue, manifest, archive, batches and patches. Ids are looked up
 * in the store and never become paths. A request for a model that is still being encoded waits without holding a
 * thread. {@code docs/protocol.md} describes all.
 */
public final class StreamingServlet extends HttpServlet {
    private static final long serialVersionUID = 1L;
    private static final Logger LOG = System.getLogger(StreamingServlet.class.getName());
    private static final String ARRIVED = StreamingServlet.class.getName() + ".arrived";
    private static final String RETRY_SECONDS = "5";

    private final transient ModelStore store;
    private final transient CrossOrigin crossOrigin;
    private final transient ArchiveResponse archiveBytes;
    private final transient Patches patches;
    private final transient UploadRequests uploads;

    public StreamingServlet(ModelStore store, ServletSettings settings) {
        this.store = store;
        crossOrigin = new CrossOrigin(settings.origins());
        archiveBytes = new ArchiveResponse(settings);
        patches = new Patches(archiveBytes);
        uploads = new UploadRequests(store);
    }

    @Override
    protected void service(HttpServletRequest request, HttpServletResponse response) throws IOException {
        try {
            crossOrigin.allow(request, response);
            switch (request.getMethod()) {
                case "GET", "HEAD" -> route(request, response);
                case "OPTIONS" -> crossOrigin.preflight(response, Answer.METHODS);
                case "POST" -> upload(request, response);
                default -> Answer.methodNotAllowed(request, response);
            }
        } catch (IOException | RuntimeException e) {
            if (response.isCommitted()) throw e;
            LOG.log(Level.ERROR, "Cannot answer " + request.getRequestURI(), e);
            int status = HttpServletResponse.SC_INTERNAL_SERVER_ERROR;
            Answer.error(request, response, status, "the server failed to answer", "see the server's log");
        }
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
            ResourcePath resource = ResourcePath.parse(path);
            if (resource != null && resource.kind() == ResourcePath.Kind.STATUS && uploads.isOn()) {
                uploads.status(request, response, resource.id());
                return;
            }
            Optional<ModelEntry> entry = resource == null ? Optional.empty() : store.find(resource.id());
            if (entry.isPresent() && resource.isOfArchive()) serve(request, response, resource, entry.get());
            else
                notFound(
                        request,
                        response,
                        "there is no such model or resource",
                        "see the catalogue at /m/ for what there is");
        }
    }

    private void upload(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String path = request.getPathInfo();
        ResourcePath resource = path == null || path.equals("/") ? null : ResourcePath.parse(path);
        boolean isModel = resource != null && resource.kind() == ResourcePath.Kind.MODEL;
        if (isModel && uploads.isOn()) uploads.receive(request, response, resource.id());
        else Answer.methodNotAllowed(request, response);
    }

    private void catalogue(HttpServletRequest request, HttpServletResponse response, boolean page) throws IOException {
        response.addHeader("Vary", "Accept");
        if (page) {
            response.setHeader("Cache-Control", "no-cache");
            Answer.redirect(response, HttpServletResponse.SC_SEE_OTHER, "../");
        } else {
            Document.of("application/json", Catalogue.json(store.list())).send(request, response, "no-cache");
        }
    }

    private static boolean wantsPage(String accept) {
        String types = accept == null ? "" : accept.toLowerCase(Locale.ROOT);
        return types.contains("text/html") && !types.contains("application/json");
    }

    private void serve(
            HttpServletRequest request, HttpServletResponse response, ResourcePath resource, ModelEntry entry)
            throws IOException {
        long arrived = arrived(request);
        try {
            boolean bytes = resource.kind() != ResourcePath.Kind.MANIFEST;
            Archive archive = bytes ? store.recent(entry) : null;
            if (archive == null) {
                CompletableFuture<Archive> future = store.archive(entry);
                if (!future.isDone()) {
                    request.setAttribute(ARRIVED, arrived);
                    awaitAndComeBack(request, future);
                    return;
                }
                archive = future.join();
            }
            response.setHeader("Server-Timing", timing(System.nanoTime() - arrived));
            if (bytes) sendBytes(request, response, resource, archive);
            else ManifestJson.send(request, response, entry, archive);
        } catch (ModelUnavailableException e) {
            unavailable(request, response, e);
        } catch (CompletionException e) {
            unavailable(request, response, (ModelUnavailableException) e.getCause());
        }
    }

    /** When the request came first, if it has waited for an encoding meanwhile. */
    private static long arrived(HttpServletRequest request) {
        boolean again = request.getDispatcherType() == DispatcherType.ASYNC;
        return again && request.getAttribute(ARRIVED) instanceof Long first ? first : System.nanoTime();
    }

    private static String timing(long nanos) {
        String micros = Long.toString(1_000_000 + nanos / 1000 % 1_000_000);
        // Digits behind the point, always three; a format string would take longer than the rest of the answer.
        return "prepare;dur=" + nanos / 1_000_000 + '.' + micros.substring(4);
    }

    private static void awaitAndComeBack(HttpServletRequest request, CompletableFuture<Archive> future) {
        AsyncContext async = request.startAsync();
        // An encoding always ends, and a large one takes longer than any container's default.
        async.setTimeout(0);
        future.whenComplete((archive, failure) -> async.dispatch());
    }

    private void sendBytes(
            HttpServletRequest request, HttpServletResponse response, ResourcePath resource, Archive archive)
            throws IOException {
        if (!resource.sha256().equals(archive.sha256())) {
            String reason = "the archive of this model is another one by now: " + archive.sha256();
            notFound(request, response, reason, "read the model's manifest.json again and start from the beginning");
            return;
        }
        switch (resource.kind()) {
            case ARCHIVE -> archiveBytes.sendArchive(request, response, archive);
            case PATCHES -> patches.send(request, response, archive);
            default -> {
                int last = archive.batches().size() - 1;
                if (resource.first() <= resource.last() && resource.last() <= last)
                    archiveBytes.sendBatches(request, response, archive, resource.first(), resource.last());
                else
                    notFound(
                            request,
                            response,
                            "the archive has the batches 0 to " + last,
                            "ask for batches that exist");
            }
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
