package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.servlet.DispatcherType;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStatus;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ModelUnavailableException;

/**
 * Manifest, archive, batches and patches of a model, which is encoded first if need be. Requests wait a moment for
 * that, then hear how far it is.
 */
final class ModelRequests {
    private static final String ARRIVED = ModelRequests.class.getName() + ".arrived";
    private static final String PREPARING_SECONDS = "1";

    private final ModelStore store;
    private final Waits waits;
    private final ArchiveResponse archiveBytes = new ArchiveResponse();
    private final Patches patches;

    ModelRequests(ModelStore store, Waits waits) {
        this.store = store;
        this.waits = waits;
        patches = new Patches(archiveBytes);
    }

    void serve(HttpServletRequest request, HttpServletResponse response, ResourcePath resource, ModelEntry entry)
            throws IOException {
        long arrived = arrived(request);
        try {
            boolean bytes = resource.kind() != ResourcePath.Kind.MANIFEST;
            Archive archive = bytes ? store.recent(entry) : null;
            if (archive == null) {
                CompletableFuture<Archive> future = store.archive(entry, ClientName.of(request));
                if (!future.isDone()) {
                    request.setAttribute(ARRIVED, arrived);
                    if (!waits.begin(request, future, store.isOpening(entry), Waits.MILLIS))
                        preparing(request, response, entry, bytes);
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

    /**
     * Says how far the archive is. A client that asks for bytes gets an error, because nobody must take this for them.
     */
    private void preparing(HttpServletRequest request, HttpServletResponse response, ModelEntry entry, boolean bytes)
            throws IOException {
        response.setHeader("Retry-After", PREPARING_SECONDS);
        ModelStatus status = store.status(entry);
        String stage = status.stage() == null ? "waiting" : status.stage();
        if (bytes) {
            String reason = "the archive is being made (" + stage + ")";
            Answer.error(request, response, HttpServletResponse.SC_SERVICE_UNAVAILABLE, reason, "ask again later");
            return;
        }
        ObjectNode body = Answer.JSON.createObjectNode().put("id", entry.id()).put("name", entry.name());
        body.put("state", "preparing").put("stage", stage).put("fraction", status.fraction());
        response.setHeader("Cache-Control", "no-store");
        Answer.json(request, response, HttpServletResponse.SC_ACCEPTED, Answer.JSON.writeValueAsBytes(body));
    }

    /** Time of the request's first arrival, if it has waited for an encoding since. */
    private static long arrived(HttpServletRequest request) {
        boolean again = request.getDispatcherType() == DispatcherType.ASYNC;
        return again && request.getAttribute(ARRIVED) instanceof Long first ? first : System.nanoTime();
    }

    private static String timing(long nanos) {
        String micros = Long.toString(1_000_000 + nanos / 1000 % 1_000_000);
        // Always three digits behind the point. A format string would take longer than the rest of the answer.
        return "prepare;dur=" + nanos / 1_000_000 + '.' + micros.substring(4);
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
            case FIRST -> archiveBytes.sendFirst(request, response, archive);
            case POSTER -> {
                if (archive.batches().poster() >= 0) archiveBytes.sendPoster(request, response, archive);
                else
                    notFound(
                            request,
                            response,
                            "the archive of this model has no poster",
                            "encode the model again with a poster, or draw its first batches");
            }
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
        if (e.isPassing()) response.setHeader("Retry-After", Long.toString(e.retrySeconds()));
        int status = e.isPassing()
                ? HttpServletResponse.SC_SERVICE_UNAVAILABLE
                : e.isGone() ? HttpServletResponse.SC_NOT_FOUND : 422;
        Answer.error(request, response, status, e.getMessage(), e.remedy());
    }

    private static void notFound(HttpServletRequest request, HttpServletResponse response, String reason, String remedy)
            throws IOException {
        Answer.error(request, response, HttpServletResponse.SC_NOT_FOUND, reason, remedy);
    }
}
