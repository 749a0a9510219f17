package org.jsmesh.app;

import java.io.IOException;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.io.Content;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.server.handler.StatisticsHandler;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.jsmesh.store.ModelStatus;
import org.jsmesh.store.ModelStore;

/**
 * Tells programs that look after a server how it is, at a port of its own: {@code /health/live}, {@code /health/ready} and {@code /metrics} in
 * the text format of Prometheus.
 */
final class ManagementServer implements AutoCloseable {
    private final Server server;
    private final ServerConnector connector;

    private ManagementServer(String host, int port, ModelStore store, StatisticsHandler statistics) {
        server = new Server(new QueuedThreadPool(4, 1));
        connector = new ServerConnector(server, 1, 1);
        connector.setHost(host);
        connector.setPort(port);
        server.addConnector(connector);
        server.setErrorHandler(new ShortErrors());
        server.setHandler(new Resources(store, statistics));
    }

    /**
     * @param statistics of the server that is looked after
     * @throws IOException when the address cannot be listened at
     */
    static ManagementServer start(String host, int port, ModelStore store, StatisticsHandler statistics)
            throws IOException {
        ManagementServer started = new ManagementServer(host, port, store, statistics);
        try {
            started.server.start();
            return started;
        } catch (Exception e) {
            started.close();
            throw e instanceof IOException io ? io : new IOException(e);
        }
    }

    int port() {
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
        private final ModelStore store;
        private final StatisticsHandler statistics;

        Resources(ModelStore store, StatisticsHandler statistics) {
            this.store = store;
            this.statistics = statistics;
        }

        @Override
        public boolean handle(Request request, Response response, Callback callback) {
            boolean known =
                    switch (Request.getPathInContext(request)) {
                        case "/health/live", "/health/ready", "/metrics" -> true;
                        default -> false;
                    };
            if (!known) return false;
            if (!request.getMethod().equals("GET") && !request.getMethod().equals("HEAD")) {
                response.getHeaders().put(HttpHeader.ALLOW, "GET, HEAD");
                Response.writeError(request, response, callback, HttpStatus.METHOD_NOT_ALLOWED_405);
                return true;
            }
            switch (Request.getPathInContext(request)) {
                case "/health/live" -> answer(response, callback, 200, "live\n");
                case "/health/ready" -> ready(response, callback);
                default -> metrics(response, callback);
            }
            return true;
        }

        private void ready(Response response, Callback callback) {
            try {
                store.list();
                answer(response, callback, 200, "ready\n");
            } catch (IOException e) {
                answer(response, callback, 503, "the models cannot be listed\n");
            }
        }

        private void metrics(Response response, Callback callback) {
            StringBuilder text = new StringBuilder();
            counter(text, "jsm_requests_total", "Requests answered or being answered.", statistics.getRequestTotal());
            counter(text, "jsm_sent_bytes_total", "Bytes of content sent.", statistics.getBytesWritten());
            text.append("# HELP jsm_responses_total Answers by class of status.\n# TYPE jsm_responses_total counter\n");
            int[] byClass = {
                statistics.getResponses2xx(),
                statistics.getResponses3xx(),
                statistics.getResponses4xx(),
                statistics.getResponses5xx()
            };
            for (int i = 0; i < byClass.length; i++) {
                text.append("jsm_responses_total{status=\"")
                        .append(i + 2)
                        .append("xx\"} ")
                        .append(byClass[i])
                        .append('\n');
            }
            models(text);
            answer(response, callback, 200, text.toString());
        }

        private void models(StringBuilder text) {
            Map<ModelStatus.State, Integer> counts = new EnumMap<>(ModelStatus.State.class);
            for (ModelStatus.State state : ModelStatus.State.values()) counts.put(state, 0);
            try {
                for (ModelStatus model : store.list()) counts.merge(model.state(), 1, Integer::sum);
            } catch (IOException e) {
                // Nothing can be counted; /health/ready says so.
            }
            text.append("# HELP jsm_models Models by state.\n# TYPE jsm_models gauge\n");
            counts.forEach((state, count) -> text.append("jsm_models{state=\"")
                    .append(state.name().toLowerCase(Locale.ROOT))
                    .append("\"} ")
                    .append(count)
                    .append('\n'));
        }

        private static void counter(StringBuilder text, String name, String help, long value) {
            text.append("# HELP ").append(name).append(' ').append(help).append('\n');
            text.append("# TYPE ")
                    .append(name)
                    .append(" counter\n")
                    .append(name)
                    .append(' ')
                    .append(value)
                    .append('\n');
        }

        private static void answer(Response response, Callback callback, int status, String text) {
            response.setStatus(status);
            response.getHeaders().put(HttpHeader.CONTENT_TYPE, "text/plain; version=0.0.4; charset=utf-8");
            response.getHeaders().put(HttpHeader.CACHE_CONTROL, "no-store");
            Content.Sink.write(response, true, text, callback);
        }
    }
}
