package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import org.jsmesh.servlet.http.BodyDigests;
import org.jsmesh.upload.QuotaException;
import org.jsmesh.upload.Sender;
import org.jsmesh.upload.Upload;
import org.jsmesh.upload.UploadQueue;

/** A model that comes as the body of one request: {@code POST {id}}. Nothing of the body is held in memory. */
final class PlainUpload {
    private static final Logger LOG = System.getLogger(PlainUpload.class.getName());

    private final UploadGate gate;
    private final UploadQueue queue;
    private final HttpServletRequest request;
    private final HttpServletResponse response;

    PlainUpload(UploadGate gate, UploadQueue queue, HttpServletRequest request, HttpServletResponse response) {
        this.gate = gate;
        this.queue = queue;
        this.request = request;
        this.response = response;
    }

    /** Answers, unless the model was accepted. */
    boolean receive(String id) throws IOException {
        Sender sender = gate.sender(request, response, id);
        if (sender == null || !gate.isFree(request, response, id)) return false;
        String extension = SentName.extension(request);
        long length = request.getContentLengthLong();
        if (extension == null) {
            refuse(415, "that is no model file", UploadGate.SEND);
        } else if (length < 0 && request.getHeader("Transfer-Encoding") == null && isHttp1()) {
            refuse(411, "the request does not tell its length", "send Content-Length");
        } else if (length == 0) {
            refuse(422, "the file is empty", UploadGate.SEND);
        } else if (length > queue.settings().mostBytes()) {
            gate.tooLarge(request, response);
        } else {
            return receive(sender, id, extension);
        }
        return false;
    }

    private boolean isHttp1() {
        return request.getProtocol().startsWith("HTTP/1");
    }

    private boolean receive(Sender sender, String id, String extension) throws IOException {
        BodyDigests digests;
        Upload begun;
        try {
            digests = BodyDigests.of(request);
            begun = queue.begin(sender, id, extension);
        } catch (IllegalArgumentException e) {
            refuse(400, e.getMessage(), "send it as 'sha-256=:BASE64:', or leave it out");
            return false;
        } catch (QuotaException e) {
            refuse(413, e.getMessage(), e.remedy());
            return false;
        }
        if (begun == null) {
            gate.busy(request, response);
            return false;
        }
        try (Upload upload = begun) {
            return receive(upload, digests);
        } catch (Upload.SpoolException e) {
            LOG.log(Level.ERROR, "Cannot take a model", e);
            gate.noRoom(request, response);
        } catch (IOException e) {
            if (response.isCommitted()) throw e;
            // The sender has gone away or breaks the protocol; the log need not have that.
            refuse(400, "the file did not come whole", "send it again");
        }
        return false;
    }

    private boolean receive(Upload upload, BodyDigests digests) throws IOException {
        long bytes = upload.receive(digests.watch(request.getInputStream()));
        boolean fits = bytes <= queue.settings().mostBytes();
        boolean isGood = bytes > 0 && fits && digests.match();
        // Frees the place before the answer, so that a sender that hears of the error can send another model.
        if (!isGood) upload.forget();
        if (!fits) gate.tooLarge(request, response);
        else if (bytes == 0) refuse(422, "the file is empty", UploadGate.SEND);
        else if (!isGood) refuse(400, "what came is not what its digest says", "send it again");
        else upload.accept();
        return isGood;
    }

    private void refuse(int status, String reason, String remedy) throws IOException {
        UploadGate.refuse(request, response, status, reason, remedy);
    }
}
