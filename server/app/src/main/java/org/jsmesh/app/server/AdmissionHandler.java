package org.jsmesh.app.server;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.eclipse.jetty.http.HttpHeader;
import org.eclipse.jetty.io.EofException;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.BufferUtil;
import org.eclipse.jetty.util.Callback;
import org.eclipse.jetty.util.component.Graceful;

/**
 * Every request passes this handler first. It turns away requests beyond the limits and those that come while the
 * server drains. It follows the others to their end, and lets them end before the server stops.
 */
final class AdmissionHandler extends Handler.Wrapper implements Graceful, Exchange.Listener {
    private static final String FORWARDED = "X-Forwarded-For";
    /** Tells the application whose request it is. */
    private static final String CLIENT = "org.jsmesh.client";

    private static final int FULL_RETRY_SECONDS = 10;
    private static final int BUSY_RETRY_SECONDS = 1;

    private final Limits limits;
    private final Clients clients;
    private final RequestRates rates;
    private final Predicate<Request> isQuick;
    private final List<String> origins;
    private final List<Exchange.Listener> listeners;
    private final Set<Exchange> running = ConcurrentHashMap.newKeySet();
    private volatile GuardedConnector connector;
    private final Graceful.Shutdown shutdown = new Graceful.Shutdown(this) {
        @Override
        public boolean isShutdownDone() {
            return running.isEmpty();
        }
    };

    /**
     * @param isQuick tells requests with answers that never block
     * @param origins of pages that may read refusals; {@code *} for all
     */
    AdmissionHandler(
            Limits limits,
            Clients clients,
            Predicate<Request> isQuick,
            List<String> origins,
            List<Exchange.Listener> listeners) {
        this.isQuick = isQuick;
        this.origins = List.copyOf(origins);
        this.limits = limits;
        this.clients = clients;
        rates = new RequestRates(limits);
        this.listeners = List.copyOf(listeners);
    }

    void guard(GuardedConnector guarded) {
        connector = guarded;
    }

    /** How fast each address asks. */
    RequestRates rates() {
        return rates;
    }

    /** Requests without a whole answer yet. */
    Set<Exchange> running() {
        return running;
    }

    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        Peer peer =
                connector.peer(request.getConnectionMetaData().getConnection().getEndPoint());
        if (peer == null) {
            callback.failed(new EofException("the client is gone"));
            return true;
        }
        Client named = peer.isProxy() ? clients.forwarded(forwarded(request)) : null;
        Client client = named == null ? peer.client() : named;
        request.setAttribute(CLIENT, client.address());
        // A proxy that names no client stands for many.
        boolean isMany = named == null && peer.isProxy();
        int tooFast = isMany ? 0 : rates.take(client.address());
        boolean counted = !isMany && tooFast == 0 && client.begin(limits.requestsPerAddress());
        request.addHttpStreamWrapper(stream -> {
            Exchange exchange = new Exchange(stream, request, peer, client, counted, this);
            running.add(exchange);
            return exchange;
        });
        // Waits not for ever, because an HTTP/2 connection stays, and others may have gone meanwhile.
        boolean excess = peer.isExcess() && connector.connections() > limits.connections();
        if (excess) return refuseAll(request, response, callback, "the server has too many connections");
        if (tooFast > 0) return refuse(request, response, callback, 429, "your address asks too fast", tooFast);
        if (!isMany && !counted) {
            String reason = "too many requests of your address are being answered";
            return refuse(request, response, callback, 503, reason, BUSY_RETRY_SECONDS);
        }
        if (isShutdown()) return refuseAll(request, response, callback, "the server is stopping");
        if (isQuick.test(request)) return super.handle(request, response, callback);
        request.getComponents().getExecutor().execute(() -> handleElsewhere(request, response, callback));
        return true;
    }

    /**
     * Some proxies append to the field, others append a field; the last proxy's entry is last in both cases. Null when
     * there is none.
     */
    private static String forwarded(Request request) {
        List<String> fields = request.getHeaders().getValuesList(FORWARDED);
        return fields.isEmpty() ? null : String.join(",", fields);
    }

    private void handleElsewhere(Request request, Response response, Callback callback) {
        try {
            if (!super.handle(request, response, callback)) Response.writeError(request, response, callback, 404);
        } catch (Exception e) {
            Response.writeError(request, response, callback, e);
        } catch (Throwable e) {
            // The client must not wait for ever. The pool logs the exception.
            Response.writeError(request, response, callback, e);
            throw e;
        }
    }

    /**
     * The thread that finds a request for bytes may answer it, because such requests never wait. All others get a
     * thread of their own.
     */
    @Override
    public InvocationType getInvocationType() {
        return InvocationType.NON_BLOCKING;
    }

    /** Refuses the request, and the connection with it. */
    private boolean refuseAll(Request request, Response response, Callback callback, String reason) {
        response.getHeaders().put(HttpHeader.CONNECTION, "close");
        return refuse(request, response, callback, 503, reason, FULL_RETRY_SECONDS);
    }

    private boolean refuse(
            Request request, Response response, Callback callback, int status, String reason, int retrySeconds) {
        response.setStatus(status);
        response.getHeaders().put(HttpHeader.RETRY_AFTER, Integer.toString(retrySeconds));
        response.getHeaders().put(HttpHeader.CONTENT_TYPE, "application/json");
        response.getHeaders().put(HttpHeader.CACHE_CONTROL, "no-store");
        allow(request, response);
        response.getHeaders().put("X-Content-Type-Options", "nosniff");
        String body = "{\"error\":\"" + reason + "\",\"remedy\":\"ask again later, see Retry-After\"}";
        response.write(true, BufferUtil.toBuffer(body, StandardCharsets.UTF_8), callback);
        return true;
    }

    /** Lets pages of the chosen origins read the refusal and its {@code Retry-After}. */
    private void allow(Request request, Response response) {
        String origin = request.getHeaders().get(HttpHeader.ORIGIN);
        boolean all = origins.contains("*");
        if (!all) response.getHeaders().put(HttpHeader.VARY, HttpHeader.ORIGIN.asString());
        if (!all && (origin == null || !origins.contains(origin))) return;
        response.getHeaders().put(HttpHeader.ACCESS_CONTROL_ALLOW_ORIGIN, all ? "*" : origin);
        response.getHeaders().put(HttpHeader.ACCESS_CONTROL_EXPOSE_HEADERS, HttpHeader.RETRY_AFTER.asString());
    }

    @Override
    public void ended(Exchange exchange) {
        running.remove(exchange);
        if (exchange.isAdmitted()) exchange.client().end();
        if (exchange.client() != exchange.peer().client()) clients.release(exchange.client());
        for (Exchange.Listener listener : listeners) listener.ended(exchange);
        if (isShutdown()) shutdown.check();
    }

    @Override
    public boolean isShutdown() {
        return shutdown.isShutdown();
    }

    @Override
    public CompletableFuture<Void> shutdown() {
        return shutdown.shutdown();
    }

    @Override
    protected void doStart() throws Exception {
        shutdown.cancel();
        super.doStart();
    }
}
