package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.file.FileSystemException;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;

/** What people wrote about places of a model, from the file beside it. */
final class Annotations {
    private static final int UNPROCESSABLE = 422;

    private Annotations() {}

    /** @param json as it was written, or null when there is nothing */
    static void send(HttpServletRequest request, HttpServletResponse response, byte[] json) throws IOException {
        if (json == null) {
            String remedy = "write NAME." + AnnotationFile.NAME + " beside the model";
            int status = HttpServletResponse.SC_NOT_FOUND;
            Answer.error(request, response, status, "there are no annotations of this model", remedy);
            return;
        }
        Document.of("application/json", json).send(request, response, "no-cache");
    }

    /** @throws FileSystemException the failure itself, when it says nothing about the annotations */
    static void refuse(HttpServletRequest request, HttpServletResponse response, FileSystemException failure)
            throws IOException {
        if (failure.getReason() == null) throw failure;
        String reason = "the file of this model's annotations " + failure.getReason();
        Answer.error(request, response, UNPROCESSABLE, reason, "see docs/page.md for its format");
    }
}
