package org.jsmesh.servlet;

import jakarta.servlet.AsyncContext;
import jakarta.servlet.DispatcherType;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.Archive;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.ModelUnavailableException;

/** Manifest, archive, batches and patches of a model, which is encoded first if need be; no thread waits for that. */
final class ModelRequests {
    private static final String ARRIVED = ModelRequests.class.getName() + ".arrived";
    private static final String RETRY_SECONDS = "5";

    private final ModelStore store;
    private final ArchiveResponse archiveBytes;
    private final Patches patches;

    ModelRequests(ModelStore store, ServletSettings settings) {
        this.store = store;
        archiveBytes = new ArchiveResponse(settings);
        patches = new Patches(archiveBytes);
    }

    void serve(HttpServletRequest request, HttpServletResponse response, ResourcePath resource, ModelEntry entry)
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
        if (e.isPassing()) response.setHeader("Retry-After", RETRY_SECONDS);
        int status = e.isPassing() ? HttpServletResponse.SC_SERVICE_UNAVAILABLE : 422;
        Answer.error(request, response, status, e.getMessage(), e.remedy());
    }

    private static void notFound(HttpServletRequest request, HttpServletResponse response, String reason, String remedy)
            throws IOException {
        Answer.error(request, response, HttpServletResponse.SC_NOT_FOUND, reason, remedy);
    }
}
