package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.servlet.DispatcherType;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystemException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.store.ServedArchive;

/**
 * Manifest, annotations, archive, batches and patches of a model, which is encoded or fetched first if need be.
 * Requests wait a moment for that, then hear how far it is.
 */
final class ModelRequests {
    private static final String ARRIVED = ModelRequests.class.getName() + ".arrived";
    private static final String PREPARING_SECONDS = "1";

    private final Waits waits;
    private final LaunchRequests launches;
    private final ArchiveResponse archiveBytes = new ArchiveResponse();
    private final Patches patches;

    ModelRequests(Waits waits, LaunchRequests launches) {
        this.waits = waits;
        this.launches = launches;
        patches = new Patches(archiveBytes);
    }

    void serve(HttpServletRequest request, HttpServletResponse response, ResourcePath resource, AskedModel model)
            throws IOException {
        try {
            switch (resource.kind()) {
                case MANIFEST -> manifest(request, response, model);
                case ANNOTATIONS -> annotations(request, response, model);
                case LAUNCH -> {
                    CompletableFuture<String> name = model.name();
                    if (isHere(request, response, model, name, true))
                        launches.sendLaunch(request, response, model, name.join());
                }
                default -> bytes(request, response, resource, model);
            }
        } catch (ModelUnavailableException e) {
            unavailable(request, response, e);
        } catch (CompletionException e) {
            unavailable(request, response, (ModelUnavailableException) e.getCause());
        }
    }

    private void manifest(HttpServletRequest request, HttpServletResponse response, AskedModel model)
            throws IOException {
        long arrived = arrived(request);
        CompletableFuture<byte[]> manifest = model.manifest(ClientName.of(request));
        if (!isHere(request, response, model, manifest, false)) return;
        response.setHeader("Server-Timing", timing(System.nanoTime() - arrived));
        byte[] json = SignedAddresses.json(request, manifest.join());
        // Short, because the model may be encoded again, and its archive then has another URL.
        Document.of("application/json", json)
                .send(request, response, SignedAddresses.caching(request, "public, max-age=10"));
    }

    private void annotations(HttpServletRequest request, HttpServletResponse response, AskedModel model)
            throws IOException {
        CompletableFuture<byte[]> annotations;
        try {
            annotations = model.annotations();
        } catch (FileSystemException e) {
            Annotations.refuse(request, response, e);
            return;
        }
        if (isHere(request, response, model, annotations, true))
            Annotations.send(request, response, annotations.join());
    }

    private void bytes(
            HttpServletRequest request, HttpServletResponse response, ResourcePath resource, AskedModel model)
            throws IOException {
        long arrived = arrived(request);
        ServedArchive archive = model.recent(resource.sha256());
        if (archive == null) {
            CompletableFuture<? extends ServedArchive> future =
                    model.archive(ClientName.of(request), resource.sha256());
            if (!isHere(request, response, model, future, true)) return;
            archive = future.join();
        }
        response.setHeader("Server-Timing", timing(System.nanoTime() - arrived));
        sendBytes(request, response, resource, model, archive);
    }

    /** Whether the answer can be given now; otherwise it comes when the request is dispatched again, or was given. */
    private boolean isHere(
            HttpServletRequest request,
            HttpServletResponse response,
            AskedModel model,
            CompletableFuture<?> future,
            boolean isOfBytes)
            throws IOException {
        if (future.isDone()) return true;
        if (request.getAttribute(ARRIVED) == null) request.setAttribute(ARRIVED, System.nanoTime());
        if (!waits.begin(request, future, model.isOpening(), Waits.MILLIS))
            preparing(request, response, model, isOfBytes);
        return false;
    }

    /**
     * Says how far the archive is. A client that asks for bytes gets an error, because nobody must take this for them.
     */
    private void preparing(HttpServletRequest request, HttpServletResponse response, AskedModel model, boolean bytes)
            throws IOException {
        response.setHeader("Retry-After", PREPARING_SECONDS);
        AskedModel.Progress progress = model.progress();
        if (bytes) {
            String reason = model.isOpening()
                    ? "the model is still being read"
                    : "the archive is being made (" + progress.stage() + ")";
            Answer.error(request, response, HttpServletResponse.SC_SERVICE_UNAVAILABLE, reason, "ask again later");
            return;
        }
        CompletableFuture<String> name = model.name();
        ObjectNode body = Answer.JSON.createObjectNode().put("id", model.id());
        body.put("name", name.isDone() && !name.isCompletedExceptionally() ? name.join() : model.id());
        body.put("state", "preparing").put("stage", progress.stage()).put("fraction", progress.fraction());
        response.setHeader("Cache-Control", "no-store");
        Answer.json(request, response, HttpServletResponse.SC_ACCEPTED, Answer.JSON.writeValueAsBytes(body));
    }

    /** Time of the request's first arrival, if it has waited since. */
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
            HttpServletRequest request,
            HttpServletResponse response,
            ResourcePath resource,
            AskedModel model,
            ServedArchive archive)
            throws IOException {
        if (!resource.sha256().equals(archive.sha256())) {
            String reason = "the archive of this model is another one by now: " + archive.sha256();
            notFound(request, response, reason, "read the model's manifest.json again and start from the beginning");
            return;
        }
        switch (resource.kind()) {
            case ARCHIVE -> {
                URI elsewhere = request.getMethod().equals("GET") ? model.elsewhere(archive.sha256()) : null;
                if (elsewhere == null) archiveBytes.sendArchive(request, response, archive);
                else archiveBytes.redirect(request, response, archive, elsewhere);
            }
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

    static void unavailable(HttpServletRequest request, HttpServletResponse response, ModelUnavailableException e)
            throws IOException {
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
