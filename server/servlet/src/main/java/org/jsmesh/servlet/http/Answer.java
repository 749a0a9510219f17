package org.jsmesh.servlet.http;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;

/** Writes JSON answers and errors. An error is {@code {"error": reason, "remedy": what to do}}, never a stack trace. */
public final class Answer {
    public static final ObjectMapper JSON = new ObjectMapper();

    /** The methods that every resource answers. */
    public static final String METHODS = "GET, HEAD, OPTIONS";

    private static final List<String> OF_BYTES = List.of("ETag", "Content-Location", "Content-Range", "Accept-Ranges");
    private static final int DRAINED_BYTES = 16 << 10;

    private Answer() {}

    /** Refuses any other method. */
    public static void methodNotAllowed(HttpServletRequest request, HttpServletResponse response) throws IOException {
        response.setHeader("Allow", METHODS);
        leaveConnectionClean(request, response);
        String reason = request.getMethod() + " is not possible here";
        error(request, response, HttpServletResponse.SC_METHOD_NOT_ALLOWED, reason, "use GET or HEAD");
    }

    /**
     * An unread body would make the server cut the connection under the client's next request. So a small body that has
     * come is read; before any other body the end of the connection is announced.
     */
    public static void leaveConnectionClean(HttpServletRequest request, HttpServletResponse response)
            throws IOException {
        long length = request.getContentLengthLong();
        // Reads only what is there already, because a body that comes byte by byte must not hold a thread.
        if (length >= 0 && length <= DRAINED_BYTES && request.getInputStream().available() >= length) {
            request.getInputStream().readNBytes((int) length);
        } else if (request.getProtocol().startsWith("HTTP/1")) {
            response.setHeader("Connection", "close");
        }
    }

    public static void error(
            HttpServletRequest request, HttpServletResponse response, int status, String reason, String remedy)
            throws IOException {
        // Headers that were set for a success must not describe the error.
        response.setHeader("ETag", null);
        response.setHeader("Content-Location", null);
        response.setHeader("Cache-Control", "no-store");
        ObjectNode body = JSON.createObjectNode().put("error", reason).put("remedy", remedy);
        response.setStatus(status);
        response.setContentType("application/json");
        // Sets no length. With a length the answer would end here, and a thread would wait for a client that does not
        // read. Without one it is sent after the servlet has returned.
        if (!request.getMethod().equals("HEAD")) response.getOutputStream().write(JSON.writeValueAsBytes(body));
    }

    /** Says that bytes which were announced cannot be read, in place of the first of them. */
    static void lost(HttpServletResponse response, String reason) throws IOException {
        for (String name : OF_BYTES) response.setHeader(name, null);
        response.setHeader("Cache-Control", "no-store");
        // What the next request finds may be another file.
        response.setHeader("Retry-After", "1");
        response.setStatus(HttpServletResponse.SC_SERVICE_UNAVAILABLE);
        response.setContentType("application/json");
        byte[] body = JSON.writeValueAsBytes(
                JSON.createObjectNode().put("error", reason).put("remedy", "ask again"));
        response.setContentLengthLong(body.length);
        response.getOutputStream().write(body);
    }

    public static void json(HttpServletRequest request, HttpServletResponse response, int status, byte[] body)
            throws IOException {
        response.setStatus(status);
        response.setContentType("application/json");
        response.setContentLengthLong(body.length);
        if (request.getMethod().equals("HEAD")) return;
        // A request that is being read without waiting gets a short answer, which the connection takes.
        if (request.isAsyncStarted()) response.getOutputStream().write(body);
        else ResponseSender.start(request, response, body);
    }

    /** A redirection to a reference relative to the request, which holds behind proxies that change scheme or host. */
    public static void redirect(HttpServletResponse response, int status, String location) {
        response.setStatus(status);
        response.setHeader("Location", location);
        response.setContentLengthLong(0);
    }
}
