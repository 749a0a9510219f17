package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import org.jsmesh.files.AnnotationFile;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.store.ModelEntry;

/** What people wrote about places of a model, from the file beside it. */
final class Annotations {
    private static final int UNPROCESSABLE = 422;

    private Annotations() {}

    /** The address relative to the manifest's, or null when the model has none. */
    static String url(ModelEntry entry) {
        return AnnotationFile.beside(entry.path()) == null ? null : AnnotationFile.NAME;
    }

    static void send(HttpServletRequest request, HttpServletResponse response, ModelEntry entry) throws IOException {
        Path file = AnnotationFile.beside(entry.path());
        if (file == null) {
            String remedy = "write NAME." + AnnotationFile.NAME + " beside the model";
            int status = HttpServletResponse.SC_NOT_FOUND;
            Answer.error(request, response, status, "there are no annotations of this model", remedy);
            return;
        }
        try {
            Document.of("application/json", AnnotationFile.read(file)).send(request, response, "no-cache");
        } catch (FileSystemException e) {
            if (e.getReason() == null) throw e;
            String reason = "the file of this model's annotations " + e.getReason();
            Answer.error(request, response, UNPROCESSABLE, reason, "see docs/page.md for its format");
        }
    }
}
