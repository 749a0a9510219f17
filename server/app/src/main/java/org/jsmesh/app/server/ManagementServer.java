package org.jsmesh.app.server;

import java.io.IOException;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.jsmesh.store.ModelSource;

/**
 * Tells monitoring programs the state of a server, at a port of its own: {@code /health/live}, {@code /health/ready}
 * and {@code /metrics} in the text format of Prometheus.
 */
public final class ManagementServer implements AutoCloseable {
    private final Server server;
    private final ServerConnector connector;

    private ManagementServer(String host, int port, ModelSource store, JsmServer watched) {
        server = new Server(new QueuedThreadPool(4, 1));
        HttpConfiguration http = new HttpConfiguration();
        http.setSendServerVersion(false);
        connector = new ServerConnector(server, 1, 1, new HttpConnectionFactory(http));
        connector.setHost(host);
        connector.setPort(port);
        server.addConnector(connector);
        server.setErrorHandler(new ShortErrors());
        server.setHandler(new Resources(store, watched));
    }

    /**
     * @param watched server to be monitored
     * @throws IOException when it cannot listen at the address
     */
    public static ManagementServer start(String host, int port, ModelSource store, JsmServer watched)
            throws IOException {
        ManagementServer started = new ManagementServer(host, port, store, watched);
        try {
            started.server.start();
            return started;
        } catch (Exception e) {
            started.close();
            throw e instanceof IOException io ? io : new IOException(e);
        }
    }

    public int port() {
        return connector.getLocalPort();
    }

    @Override
    public void close() {
        try {
            server.stop();
        } catch (Exception e) {
            throw new IllegalStateException("the management server cannot be stopped", e);
        }
    }

    /** The three resources. */
    private static final class Resources extends Handler.Abstract {
        private final ModelSource store;
        private final JsmServer watched;

        Resources(ModelSource store, JsmServer watched) {
            this.store = store;
            this.watched = watched;
        }

        @Override
        public boolean handle(Request request, Response response, Callback callback) {
            String path = Request.getPathInContext(request);
            boolean known = switch (path) {
                case "/health/live", "/health/ready", "/metrics" -> true;
                default -> false;
            };
            if (!known) return false;
            if (!request.getMethod().equals("GET") && !request.getMethod().equals("HEAD")) {
                response.getHeaders().put(HttpHeader.ALLOW, "GET, HEAD");
                Response.writeError(request, response, callback, HttpStatus.METHOD_NOT_ALLOWED_405);
                return true;
            }
            switch (path) {
                case "/health/live" -> answer(response, callback, 200, "live\n");
                case "/health/ready" -> ready(response, callback);
                default -> answer(response, callback, 200, watched.metrics().text());
            }
            return true;
        }

        private void ready(Response response, Callback callback) {
            if (watched.isDraining()) {
                answer(response, callback, 503, "the server is stopping\n");
                return;
            }
            try {
                store.check();
                answer(response, callback, 200, "ready\n");
            } catch (IOException e) {
                answer(response, callback, 503, "the models cannot be listed\n");
            }
        }

        private static void answer(Response response, Callback callback, int status, String text) {
            response.setStatus(status);
            response.getHeaders().put(HttpHeader.CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8");
            response.getHeaders().put(HttpHeader.CACHE_CONTROL, "no-store");
            response.getHeaders().put("X-Content-Type-Options", "nosniff");
            Content.Sink.write(response, true, text, callback);
        }
    }
}
