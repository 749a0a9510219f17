package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.Map;
import org.jsmesh.store.ModelEntry;
import org.jsmesh.store.ModelStore;
import org.jsmesh.upload.QuotaException;
import org.jsmesh.upload.Resumable;
import org.jsmesh.upload.Sender;
import org.jsmesh.upload.Upload;
import org.jsmesh.upload.UploadQueue;

/**
 * Models that come in parts, by the tus protocol 1.0.0 with creation, creation with upload, expiration, checksum and
 * termination. The addresses are below {@value #FOLDER}, which is no id. What is whole goes the way of every model that
 * is sent.
 */
final class TusRequests {
    /** Below the servlet's path. */
    static final String FOLDER = "/.uploads";

    static final String METHODS = "POST, HEAD, PATCH, DELETE, OPTIONS";
    private static final Logger LOG = System.getLogger(TusRequests.class.getName());
    private static final int CHECKSUM_MISMATCH = 460;
    private static final DateTimeFormatter TIME = DateTimeFormatter.RFC_1123_DATE_TIME.withZone(ZoneOffset.UTC);

    private final ModelStore store;
    private final UploadGate gate;
    private final SignedAddresses signed;

    TusRequests(ModelStore store, UploadGate gate, SignedAddresses signed) {
        this.store = store;
        this.gate = gate;
        this.signed = signed;
    }

    private UploadQueue queue() {
        return store.uploads();
    }

    /** @param path below the servlet's, which begins with {@link #FOLDER} */
    void serve(HttpServletRequest request, HttpServletResponse response, String path) throws IOException {
        response.setHeader("Tus-Resumable", TusHeaders.VERSION);
        response.setHeader("Cache-Control", "no-store");
        String override = request.getHeader("X-HTTP-Method-Override");
        String method = override == null ? request.getMethod() : override;
        String name = path.length() <= FOLDER.length() + 1 ? "" : path.substring(FOLDER.length() + 1);
        if (method.equals("OPTIONS")) {
            describe(response);
        } else if (!TusHeaders.VERSION.equals(request.getHeader("Tus-Resumable"))) {
            response.setHeader("Tus-Version", TusHeaders.VERSION);
            refuse(request, response, 412, "Tus-Resumable is missing, or is another version", "send 1.0.0");
        } else if (name.isEmpty() && method.equals("POST")) {
            create(request, response);
        } else if (name.isEmpty() || !method.matches("HEAD|PATCH|DELETE")) {
            response.setHeader("Allow", METHODS);
            refuse(request, response, 405, method + " is not possible here", "see the tus protocol, version 1.0.0");
        } else {
            goOn(request, response, method, name);
        }
    }

    private void describe(HttpServletResponse response) {
        response.setHeader("Tus-Version", TusHeaders.VERSION);
        response.setHeader("Tus-Extension", TusHeaders.EXTENSIONS);
        response.setHeader("Tus-Max-Size", Long.toString(queue().settings().mostBytes()));
        response.setHeader("Tus-Checksum-Algorithm", TusHeaders.ALGORITHMS);
        response.setStatus(HttpServletResponse.SC_NO_CONTENT);
    }

    private void create(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String field = request.getHeader("Upload-Metadata");
        Map<String, String> metadata;
        TusHeaders.Checksum checksum;
        try {
            metadata = TusHeaders.metadata(field);
            checksum = TusHeaders.checksum(request);
        } catch (IllegalArgumentException e) {
            refuse(request, response, 400, e.getMessage(), "see the tus protocol, version 1.0.0");
            return;
        }
        String file = metadata.getOrDefault("filename", metadata.get("name"));
        String id =
                metadata.getOrDefault("id", file == null ? "" : ModelEntry.idOf(file.replaceFirst("\\.[^.]*$", "")));
        Sender sender = gate.sender(request, response, id);
        if (sender == null || !gate.isFree(request, response, id)) return;
        long length = TusHeaders.number(request, "Upload-Length");
        String extension = file == null ? SentName.ofType(metadata.get("filetype")) : SentName.ofName(file);
        if (extension == null) {
            refuse(request, response, 415, "that is no model file", UploadGate.SEND);
        } else if (length < 0) {
            refuse(request, response, 400, "Upload-Length is missing or no number", "tell the length of the file");
        } else if (length == 0) {
            refuse(request, response, 422, "the file is empty", UploadGate.SEND);
        } else if (length > queue().settings().mostBytes()) {
            gate.tooLarge(request, response);
        } else {
            String said = field == null ? "" : field;
            begin(request, response, () -> queue().resumables().begin(sender, id, extension, length, said), checksum);
        }
    }

    /** Begins an upload of which all is known. */
    private interface Beginning {
        Resumable begin() throws QuotaException, Upload.SpoolException;
    }

    private void begin(
            HttpServletRequest request, HttpServletResponse response, Beginning beginning, TusHeaders.Checksum checksum)
            throws IOException {
        Resumable upload;
        try {
            upload = beginning.begin();
        } catch (QuotaException e) {
            refuse(request, response, 413, e.getMessage(), e.remedy());
            return;
        } catch (Upload.SpoolException e) {
            LOG.log(Level.ERROR, "Cannot take a model", e);
            gate.noRoom(request, response);
            return;
        }
        if (upload == null) {
            gate.busy(request, response);
            return;
        }
        String folder = request.getRequestURI().endsWith("/") ? "" : FOLDER.substring(1) + "/";
        response.setHeader("Location", folder + upload.name());
        describe(response, upload);
        if (TusHeaders.isPart(request) && upload.begin()) {
            try {
                append(request, response, upload, checksum, HttpServletResponse.SC_CREATED);
            } finally {
                upload.end();
            }
        } else {
            response.setStatus(HttpServletResponse.SC_CREATED);
        }
    }

    private void goOn(HttpServletRequest request, HttpServletResponse response, String method, String name)
            throws IOException {
        Resumable upload = queue().resumables().find(name);
        if (upload == null) {
            String remedy = "send the model from its beginning, with POST to " + FOLDER.substring(1) + "/";
            refuse(request, response, 404, "there is no such upload, or it has expired", remedy);
            return;
        }
        if (gate.sender(request, response, upload.id()) == null) return;
        if (method.equals("HEAD")) {
            response.setHeader("Upload-Length", Long.toString(upload.length()));
            if (!upload.metadata().isEmpty()) response.setHeader("Upload-Metadata", upload.metadata());
            describe(response, upload);
            response.setStatus(HttpServletResponse.SC_OK);
        } else if (!upload.begin()) {
            refuse(request, response, 423, "a part of this upload is being received", "send the next one after that");
        } else {
            try {
                if (method.equals("DELETE")) remove(request, response, upload);
                else append(request, response, upload);
            } finally {
                upload.end();
            }
        }
    }

    private void describe(HttpServletResponse response, Resumable upload) {
        response.setHeader("Upload-Offset", Long.toString(upload.offset()));
        response.setHeader("Upload-Expires", TIME.format(queue().resumables().expires(upload)));
        String status = signed.ofSender(upload.id(), "../" + upload.id() + "/status");
        response.setHeader("Link", "<" + status + ">; rel=\"status\"");
    }

    private void remove(HttpServletRequest request, HttpServletResponse response, Resumable upload) throws IOException {
        if (upload.isOver()) {
            refuse(request, response, 409, "the upload is whole", "delete the model itself: DELETE " + upload.id());
            return;
        }
        queue().resumables().remove(upload);
        response.setStatus(HttpServletResponse.SC_NO_CONTENT);
    }

    private void append(HttpServletRequest request, HttpServletResponse response, Resumable upload) throws IOException {
        TusHeaders.Checksum checksum;
        try {
            checksum = TusHeaders.checksum(request);
        } catch (IllegalArgumentException e) {
            refuse(request, response, 400, e.getMessage(), "see the tus protocol, version 1.0.0");
            return;
        }
        long offset = TusHeaders.number(request, "Upload-Offset");
        if (!TusHeaders.isPart(request)) {
            refuse(request, response, 415, "a part has another type", "send it as " + TusHeaders.PART);
        } else if (offset < 0) {
            refuse(request, response, 400, "Upload-Offset is missing or no number", "tell where the part begins");
        } else if (offset != upload.offset()) {
            describe(response, upload);
            String reason = "the upload has " + upload.offset() + " bytes, and the part begins at " + offset;
            refuse(request, response, 409, reason, "ask with HEAD where to go on");
        } else {
            append(request, response, upload, checksum, HttpServletResponse.SC_NO_CONTENT);
        }
    }

    private void append(
            HttpServletRequest request,
            HttpServletResponse response,
            Resumable upload,
            TusHeaders.Checksum checksum,
            int success)
            throws IOException {
        if (request.getContentLengthLong() > upload.length() - upload.offset()) {
            refuse(
                    request,
                    response,
                    400,
                    "the part is longer than what is missing",
                    "send no more than was announced");
            return;
        }
        try {
            boolean good = upload.append(request.getInputStream(), checksum.digest(), checksum.value());
            if (!upload.isOver() && upload.offset() == upload.length())
                queue().resumables().complete(upload);
            describe(response, upload);
            if (good) response.setStatus(success);
            else
                refuse(request, response, CHECKSUM_MISMATCH, "the part is not what its checksum says", "send it again");
        } catch (Upload.SpoolException e) {
            LOG.log(Level.ERROR, "Cannot take a part of a model", e);
            gate.noRoom(request, response);
        } catch (IOException e) {
            if (response.isCommitted()) throw e;
            describe(response, upload);
            refuse(request, response, 400, "the part did not come whole", "ask with HEAD where to go on");
        }
    }

    private static void refuse(
            HttpServletRequest request, HttpServletResponse response, int status, String reason, String remedy)
            throws IOException {
        UploadGate.refuse(request, response, status, reason, remedy);
    }
}
