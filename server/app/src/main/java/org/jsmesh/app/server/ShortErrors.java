package org.jsmesh.app.server;

import java.util.Locale;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.server.handler.ErrorHandler;
import org.eclipse.jetty.util.Callback;

/**
 * Gives the answers to requests that Jetty itself refuses, before the application sees them, the form of the
 * application's errors.
 */
final class ShortErrors extends ErrorHandler {
    /** The answer always has a body that says why. */
    @Override
    public boolean errorPageForMethod(String method) {
        return true;
    }

    @Override
    protected void generateResponse(
            Request request, Response response, int code, String message, Throwable cause, Callback callback) {
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, "application/json");
        response.getHeaders().put("X-Content-Type-Options", "nosniff");
        Content.Sink.write(response, true, body(code), callback);
    }

    /** Only the status in words, because Jetty's own messages quote the request. */
    private static String body(int code) {
        String reason = HttpStatus.getMessage(code).toLowerCase(Locale.ROOT);
        String remedy = code == HttpStatus.METHOD_NOT_ALLOWED_405
                ? "use GET or HEAD"
                : code < 500 ? "ask for one of the addresses in the catalogue at /m/" : "see the server's log";
        return "{\"error\":\"" + reason + "\",\"remedy\":\"" + remedy + "\"}";
    }
}
