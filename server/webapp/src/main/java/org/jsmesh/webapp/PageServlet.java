package org.jsmesh.webapp;

import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.jsmesh.servlet.http.Answer;
import org.jsmesh.servlet.http.Document;
import org.jsmesh.servlet.http.PlainPath;

/**
 * The page and its scripts: files that jars carry under {@code META-INF/resources/jsm}. A servlet of our own, because
 * every container would send them with other headers, and some with the wrong type for WebAssembly. Folders are not
 * listed.
 */
final class PageServlet extends HttpServlet {
    private static final long serialVersionUID = 1L;

    private static final String FOR_EVER = "public, max-age=31536000, immutable";

    private final transient PageFiles files;

    PageServlet(PageFiles files) {
        this.files = files;
    }

    @Override
    protected void service(HttpServletRequest request, HttpServletResponse response) throws IOException {
        if (!PlainPath.check(request, response)) return;
        switch (request.getMethod()) {
            case "GET", "HEAD" -> send(request, response);
            case "OPTIONS" -> {
                response.setHeader("Allow", Answer.METHODS);
                response.setStatus(HttpServletResponse.SC_NO_CONTENT);
            }
            default -> Answer.methodNotAllowed(request, response);
        }
    }

    private void send(HttpServletRequest request, HttpServletResponse response) throws IOException {
        String path = request.getServletPath();
        Document file = files.find(path);
        if (file == null) {
            int status = HttpServletResponse.SC_NOT_FOUND;
            Answer.error(request, response, status, "there is no such page", "start at the first page");
            return;
        }
        file.send(request, response, PageFiles.isForEver(path) ? FOR_EVER : "no-cache");
    }
}
