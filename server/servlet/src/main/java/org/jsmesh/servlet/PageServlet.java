package org.jsmesh.servlet;

import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;

/**
 * The page and its scripts: files that jars carry under {@code META-INF/resources}. A servlet of our own, because every container would send
 * them with other headers, and some with the wrong type for WebAssembly. Folders are not listed.
 */
final class PageServlet extends HttpServlet {
    private static final long serialVersionUID = 1L;

    private final transient PageFiles files;

    PageServlet(PageFiles files) {
        this.files = files;
    }

    @Override
    protected void service(HttpServletRequest request, HttpServletResponse response) throws IOException {
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
        PageFiles.PageFile file = files.find(request.getServletPath());
        if (file == null) {
            int status = HttpServletResponse.SC_NOT_FOUND;
            Answer.error(request, response, status, "there is no such page", "start at the first page");
            return;
        }
        boolean compressed = file.gzip() != null && acceptsGzip(request.getHeader("Accept-Encoding"));
        String tag = '"' + file.sha256() + (compressed ? "-gzip" : "") + '"';
        response.setHeader("ETag", tag);
        response.setHeader("Cache-Control", "no-cache");
        response.setHeader("Vary", "Accept-Encoding");
        if (EntityTags.anyMatches(request.getHeader("If-None-Match"), tag)) {
            response.setStatus(HttpServletResponse.SC_NOT_MODIFIED);
            return;
        }
        byte[] body = compressed ? file.gzip() : file.bytes();
        if (compressed) response.setHeader("Content-Encoding", "gzip");
        response.setContentType(file.type());
        response.setContentLengthLong(body.length);
        if (!request.getMethod().equals("HEAD")) Transfer.start(request, response, body);
    }

    private static boolean acceptsGzip(String field) {
        if (field == null) return false;
        for (String coding : field.split(",")) {
            String plain = coding.replace(" ", "");
            if (plain.equals("gzip") || plain.startsWith("gzip;q=") && !plain.matches("gzip;q=0(\\.0*)?")) return true;
        }
        return false;
    }
}
