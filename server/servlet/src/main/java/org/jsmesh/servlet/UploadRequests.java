package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Locale;
import org.jsmesh.files.NoteJson;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.upload.UploadStatus;

/**
 * Models that clients send and delete: {@code POST {id}} and {@code DELETE {id}}, and {@code GET {id}/status}, which
 * tells how far an encoding is. It reads nothing of a body before it knows that the sender may send it.
 */
final class UploadRequests {
    private final ModelStore store; // null where nobody can send models
    private final UploadGate gate;
    private final SignedAddresses signed;
    private final TusRequests tus;

    UploadRequests(ModelStore store, SignedAddresses signed) {
        this.store = store;
        this.signed = signed;
        gate = new UploadGate(store);
        tus = new TusRequests(store, gate, signed);
    }

    boolean isOn() {
        return store != null && store.uploads() != null;
    }

    void receive(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        if (!new PlainUpload(gate, store.uploads(), request, response).receive(id)) return;
        response.setHeader("Location", signed.ofSender(id, id + "/status"));
        answer(
                request,
                response,
                HttpServletResponse.SC_ACCEPTED,
                store.uploads().status(id));
    }

    boolean isResumable(String path) {
        return isOn() && path != null && (path.equals(TusRequests.FOLDER) || path.startsWith(TusRequests.FOLDER + "/"));
    }

    /** In parts: {@link TusRequests}. */
    void resume(HttpServletRequest request, HttpServletResponse response, String path) throws IOException {
        tus.serve(request, response, path);
    }

    /** Only what was sent can be deleted. */
    void delete(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        if (gate.sender(request, response, id) == null) return;
        ModelEntry there = store.find(id).orElse(null);
        if (there != null && !store.uploads().owns(there.path())) {
            String reason = "the model " + id + " is a file of the server's folder";
            UploadGate.refuse(request, response, 409, reason, "ask the server's owner to remove it");
        } else if (UploadGate.isIdToSend(id) && store.uploads().remove(id)) {
            response.setHeader("Cache-Control", "no-store");
            response.setStatus(HttpServletResponse.SC_NO_CONTENT);
        } else {
            UploadGate.refuse(
                    request,
                    response,
                    HttpServletResponse.SC_NOT_FOUND,
                    "no model was sent under this id",
                    "see the catalogue, index.json, for what there is");
        }
    }

    void status(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        UploadStatus status = store.uploads().status(id);
        if (status == null) {
            String reason = "no model was sent under this id since the server was started";
            Answer.error(
                    request,
                    response,
                    HttpServletResponse.SC_NOT_FOUND,
                    reason,
                    "see the catalogue, index.json, for what there is");
            return;
        }
        if (!status.isOver()) response.setHeader("Retry-After", "1");
        answer(request, response, HttpServletResponse.SC_OK, status);
    }

    private void answer(HttpServletRequest request, HttpServletResponse response, int code, UploadStatus status)
            throws IOException {
        ObjectNode body = Answer.JSON.createObjectNode().put("id", status.id());
        body.put("state", status.state().name().toLowerCase(Locale.ROOT));
        switch (status.state()) {
            case READY ->
                body.put("manifestUrl", SignedAddresses.address(request, manifestUrl(status.id())))
                        .set("notes", NoteJson.array(status.notes()));
            case FAILED -> body.put("error", status.error()).put("remedy", status.remedy());
            default -> body.put("stage", status.stage()).put("fraction", status.fraction());
        }
        response.setHeader("Cache-Control", "no-store");
        Answer.json(request, response, code, Answer.JSON.writeValueAsBytes(body));
    }

    /** Relative to the status. Files that have come since may have given the model another id. */
    private String manifestUrl(String id) {
        ModelEntry entry = store.of(store.uploads().place(id));
        return entry == null || entry.id().equals(id) ? "manifest.json" : "../" + entry.segment() + "/manifest.json";
    }
}
