package org.jsmesh.servlet;

import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.files.NoteJson;
import org.jsmesh.mesh.io.ModelFormat;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.upload.Upload;
import org.jsmesh.upload.UploadQueue;
import org.jsmesh.upload.UploadStatus;
import org.jsmesh.upload.UploadTokens;

/**
 * Models that clients send: {@code POST {id}}, and {@code GET {id}/status}, which tells how far its encoding is. It
 * reads nothing of a body before it knows that the sender may send it, and holds none of it in memory.
 */
final class UploadRequests {
    private static final int LONGEST_ID = 80;
    private static final String RETRY_SECONDS = "10";
    private static final String SEND =
            "send a PLY, OBJ, STL, OFF, Hoppe .m, GLB or 3MF file, or a ZIP archive of one with its materials";
    private static final Pattern BEARER = Pattern.compile("(?i)Bearer +([A-Za-z0-9._~+/=-]+)");
    private static final Pattern FILE_NAME = Pattern.compile("(?i);\\s*filename\\s*=\\s*\"?([^\";]+)");

    /** File extensions of content types. For some types only the content tells the format. */
    private static final Map<String, String> EXTENSIONS = Map.ofEntries(
            Map.entry("application/octet-stream", "bin"),
            Map.entry("model/gltf-binary", "glb"),
            Map.entry("model/gltf+json", "gltf"),
            Map.entry("model/stl", "stl"),
            Map.entry("model/x.stl-binary", "stl"),
            Map.entry("application/sla", "stl"),
            Map.entry("application/vnd.ms-pki.stl", "stl"),
            Map.entry("model/obj", "obj"),
            Map.entry("model/ply", "ply"),
            Map.entry("application/ply", "ply"),
            Map.entry("model/off", "off"),
            Map.entry("model/3mf", "3mf"),
            Map.entry("application/vnd.ms-package.3dmanufacturing-3dmodel+xml", "3mf"),
            Map.entry("application/gzip", "gz"),
            Map.entry("application/zip", "zip"),
            Map.entry("application/x-zip-compressed", "zip"));

    private final ModelStore store;

    UploadRequests(ModelStore store) {
        this.store = store;
    }

    boolean isOn() {
        return store.uploads() != null;
    }

    void receive(HttpServletRequest request, HttpServletResponse response, String id) throws IOException {
        UploadQueue queue = store.uploads();
        if (!isAllowed(request, response, queue, id)) return;
        ModelEntry inTheWay = store.inTheWayOf(id);
        String extension = extension(request);
        long length = request.getContentLengthLong();
        if (!isIdToSend(id)) {
            String remedy =
                    "use up to " + LONGEST_ID + " lower-case Latin letters, digits and single hyphens between them";
            refuse(request, response, 400, "'" + id + "' is no id of a model", remedy);
        } else if (inTheWay != null) {
            String reason = inTheWay.id().equals(id)
                    ? "the model " + id + " is a file of the server's folder"
                    : "files of the server's folder are named " + inTheWay.name() + ", too";
            refuse(request, response, 409, reason, "use another id");
        } else if (extension == null) {
            refuse(request, response, 415, "that is no model file", SEND);
        } else if (length < 0 && request.getHeader("Transfer-Encoding") == null && isHttp1(request)) {
            refuse(request, response, 411, "the request does not tell its length", "send Content-Length");
        } else if (length == 0) {
            refuse(request, response, 422, "the file is empty", SEND);
        } else if (length > queue.settings().mostBytes()) {
            tooLarge(request, response, queue);
        } else {
            spool(request, response, queue, id, extension);
        }
    }

    /** Whether a model may be sent under it: it names a file on any system. */
    private static boolean isIdToSend(String id) {
        return id.length() <= LONGEST_ID
                && id.matches("[a-z0-9-]+")
                && ModelEntry.idOf(id).equals(id);
    }

    private static boolean isHttp1(HttpServletRequest request) {
        return request.getProtocol().startsWith("HTTP/1");
    }

    private static boolean isAllowed(
            HttpServletRequest request, HttpServletResponse response, UploadQueue queue, String id) throws IOException {
        String field = request.getHeader("Authorization");
        Matcher bearer = BEARER.matcher(field == null ? "" : field.strip());
        UploadTokens.Verdict verdict =
                bearer.matches() ? queue.settings().tokens().check(bearer.group(1), id) : UploadTokens.Verdict.UNKNOWN;
        switch (verdict) {
            case GOOD -> {
                return true;
            }
            case ELSEWHERE ->
                refuse(request, response, 403, "this token is not good for the model " + id, "use another id");
            default -> {
                response.setHeader("WWW-Authenticate", bearer.matches() ? "Bearer error=\"invalid_token\"" : "Bearer");
                refuse(
                        request,
                        response,
                        401,
                        "only who has a token may send models",
                        "send 'Authorization: Bearer TOKEN' with a token of this server");
            }
        }
        return false;
    }

    /**
     * The extension by the name that the sender gives the file, or else by the type of the content; null when neither
     * is that of a model.
     */
    private static String extension(HttpServletRequest request) {
        String name = queryName(request);
        String disposition = request.getHeader("Content-Disposition");
        Matcher file = FILE_NAME.matcher(disposition == null ? "" : disposition);
        if (name == null && file.find()) name = file.group(1);
        if (name != null) {
            String lower = name.toLowerCase(Locale.ROOT).strip();
            if (lower.endsWith(".zip")) return "zip";
            if (ModelFormat.ofName(lower) == null) return null;
            return lower.endsWith(".gz") ? "gz" : lower.substring(lower.lastIndexOf('.') + 1);
        }
        String type = request.getContentType();
        if (type == null) return "bin";
        return EXTENSIONS.get(type.replaceFirst(";.*$", "").strip().toLowerCase(Locale.ROOT));
    }

    /** Not by getParameter, which would take the body of a form for parameters. */
    private static String queryName(HttpServletRequest request) {
        String query = request.getQueryString();
        if (query == null) return null;
        for (String pair : query.split("&")) if (pair.startsWith("name=")) return pair.substring("name=".length());
        return null;
    }

    private void spool(
            HttpServletRequest request, HttpServletResponse response, UploadQueue queue, String id, String extension)
            throws IOException {
        Upload begun = queue.begin(id, extension);
        if (begun == null) {
            response.setHeader("Retry-After", RETRY_SECONDS);
            refuse(request, response, 429, "the queue is full", "send the model again later");
            return;
        }
        try (Upload upload = begun) {
            long bytes = upload.receive(request.getInputStream());
            boolean isGood = bytes > 0 && bytes <= queue.settings().mostBytes();
            // Frees the place before the answer, so that a sender that hears of the error can send another model.
            if (!isGood) upload.forget();
            if (bytes > queue.settings().mostBytes()) {
                tooLarge(request, response, queue);
            } else if (bytes == 0) {
                refuse(request, response, 422, "the file is empty", SEND);
            } else {
                upload.accept();
                response.setHeader("Location", id + "/status");
                answer(request, response, HttpServletResponse.SC_ACCEPTED, queue.status(id));
            }
        } catch (Upload.SpoolException e) {
            System.getLogger(UploadRequests.class.getName()).log(System.Logger.Level.ERROR, "Cannot take a model", e);
            response.setHeader("Retry-After", RETRY_SECONDS);
            refuse(request, response, 503, "the server has no room for the model", "send it again later");
        } catch (IOException e) {
            if (response.isCommitted()) throw e;
            // The sender has gone away or breaks the protocol; the log need not have that.
            refuse(request, response, 400, "the file did not come whole", "send it again");
        }
    }

    private static void tooLarge(HttpServletRequest request, HttpServletResponse response, UploadQueue queue)
            throws IOException {
        String reason = "the file has more than the " + queue.settings().mostBytes() + " bytes allowed";
        refuse(request, response, 413, reason, "send a smaller model");
    }

    private static void refuse(
            HttpServletRequest request, HttpServletResponse response, int status, String reason, String remedy)
            throws IOException {
        try {
            Answer.leaveConnectionClean(request, response);
        } catch (IOException e) {
            response.setHeader("Connection", "close");
        }
        Answer.error(request, response, status, reason, remedy);
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
                body.put("manifestUrl", manifestUrl(status.id())).set("notes", NoteJson.array(status.notes()));
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
