package org.jsmesh.app.server;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.concurrent.TimeoutException;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.eclipse.jetty.alpn.server.ALPNServerConnectionFactory;
import org.eclipse.jetty.ee11.servlet.ServletContextHandler;
import org.eclipse.jetty.http2.server.AbstractHTTP2ServerConnectionFactory;
import org.eclipse.jetty.io.WindowRateControl;
import org.eclipse.jetty.server.ConnectionFactory;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.SecureRequestCustomizer;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.util.URIUtil;
import org.eclipse.jetty.util.ssl.SslContextFactory;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.jsmesh.store.ModelSource;
import org.jsmesh.webapp.StreamingApplication;

/**
 * A Jetty that serves a store: HTTP/1.1 and HTTP/2 on one port, without encryption (h2c with prior knowledge) or, with
 * a keystore, with TLS (h2 by ALPN). Thread-safe.
 */
public final class JsmServer implements AutoCloseable {
    private static final Logger LOG = Logger.getLogger(JsmServer.class.getName());

    /** Most HTTP/2 requests at a time on a connection. More would be no faster, and each costs memory. */
    private static final int STREAMS = 64;

    /**
     * Frames a second besides those that carry content (resets, pings, settings): a client that sends more means harm.
     */
    private static final int CONTROL_FRAMES_PER_SECOND = 128;

    /** Kept in a field, because a logger without a reference forgets its level. */
    private static final Logger JETTY_LOG = Logger.getLogger("org.eclipse.jetty");

    private final Server server;
    private final GuardedConnector connector;
    private final AdmissionHandler door;
    private final Metrics metrics;
    private final boolean encrypted;
    private volatile boolean draining;

    private JsmServer(ServerSettings settings, ModelSource store, AccessLog log) {
        JETTY_LOG.setLevel(Level.WARNING);
        QueuedThreadPool threads = new QueuedThreadPool();
        threads.setName("jsm-http");
        server = new Server(threads);
        server.setStopTimeout(settings.graceMillis());
        encrypted = settings.keystore() != null;
        Limits limits = settings.limits();
        Clients clients = new Clients(settings.proxies());
        connector = new GuardedConnector(server, limits, clients, encrypted ? encrypted(settings) : plain(limits));
        connector.setHost(settings.host());
        connector.setPort(settings.port());
        connector.setIdleTimeout(limits.idleMillis());
        // The watchman closes idle connections of a server that stops; a slow transfer is not idle.
        connector.setShutdownIdleTimeout(-1);
        server.addConnector(connector);
        ServletContextHandler context = new ServletContextHandler("/");
        context.addServletContainerInitializer(
                (classes, application) -> StreamingApplication.install(application, store, settings.servlet()));
        context.setErrorHandler(new ShortErrors());
        server.setErrorHandler(new ShortErrors());
        metrics = new Metrics(store);
        door = new AdmissionHandler(
                limits,
                clients,
                request -> isQuick(request, store),
                settings.servlet().origins(),
                log == null ? List.of(metrics) : List.of(metrics, log));
        door.guard(connector);
        door.setHandler(context);
        server.setHandler(door);
        SlowConnectionGuard watchman = new SlowConnectionGuard(limits, connector, door);
        server.addBean(watchman);
        metrics.watch(connector, door, clients, watchman);
        if (log != null) metrics.watch(log);
    }

    /**
     * Starts a server.
     *
     * @param store the caller closes it after the server
     * @throws IOException when the server cannot listen at the address or cannot read the keystore
     */
    public static JsmServer start(ServerSettings settings, ModelSource store) throws IOException {
        return start(settings, store, null);
    }

    /** @param log of requests, or null; the caller closes it after the server */
    public static JsmServer start(ServerSettings settings, ModelSource store, AccessLog log) throws IOException {
        if (settings.keystore() != null && !Files.isReadable(settings.keystore())) {
            throw new NoSuchFileException(settings.keystore().toString());
        }
        JsmServer started = new JsmServer(settings, store, log);
        try {
            started.server.start();
            return started;
        } catch (Exception e) {
            started.close();
            if (e instanceof IOException io) throw io;
            throw new IOException(e.getMessage(), e);
        }
    }

    private static ConnectionFactory[] plain(Limits limits) {
        HttpConfiguration http = http(limits);
        return new ConnectionFactory[] {new HttpConnectionFactory(http), guarded(new PriorKnowledgeHttp2(http), limits)
        };
    }

    private static ConnectionFactory[] encrypted(ServerSettings settings) {
        HttpConfiguration http = http(settings.limits());
        // The name in the certificate need not be the one that a proxy or a test calls the server by.
        http.addCustomizer(new SecureRequestCustomizer(false));
        SslContextFactory.Server tls = new SslContextFactory.Server();
        tls.setKeyStorePath(settings.keystore().toString());
        tls.setKeyStorePassword(settings.keystorePassword());
        ALPNServerConnectionFactory alpn = new ALPNServerConnectionFactory();
        alpn.setDefaultProtocol("http/1.1");
        ShortRecords ssl = new ShortRecords(tls, alpn.getProtocol());
        return new ConnectionFactory[] {
            ssl, alpn, guarded(new ShortFrames(http), settings.limits()), new HttpConnectionFactory(http)
        };
    }

    /**
     * The bytes of a ready archive are sent as the connection takes them. A request that lists folders or reads a body
     * may take time.
     */
    private static boolean isQuick(Request request, ModelSource store) {
        String path = request.getHttpURI().getCanonicalPath();
        if (!request.getMethod().equals("GET") || !ResourceKind.of("GET", path).isBytes()) return false;
        int end = path.indexOf('/', ResourceKind.ROOT.length());
        return end > 0 && store.isKnown(URIUtil.decodePath(path.substring(ResourceKind.ROOT.length(), end)));
    }

    private static ConnectionFactory guarded(AbstractHTTP2ServerConnectionFactory http2, Limits limits) {
        http2.setMaxConcurrentStreams(STREAMS);
        http2.setStreamIdleTimeout(limits.idleMillis());
        http2.setRateControlFactory(new WindowRateControl.Factory(CONTROL_FRAMES_PER_SECOND));
        return http2;
    }

    private static HttpConfiguration http(Limits limits) {
        HttpConfiguration http = new HttpConfiguration();
        http.setSendServerVersion(false);
        http.setRequestHeaderSize(limits.headerBytes());
        // A cache of fields takes 100 kB of heap for each connection, and saves no measurable time.
        http.setHeaderCacheSize(0);
        return http;
    }

    /** Address of the page, with a name that a browser on this machine can open; ends with a slash. */
    public URI uri() {
        String host = connector.getHost();
        boolean everywhere = host == null || host.equals("0.0.0.0") || host.equals("::");
        String name = everywhere ? "localhost" : host.contains(":") ? "[" + host + "]" : host;
        return URI.create((encrypted ? "https://" : "http://") + name + ":" + connector.getLocalPort() + "/");
    }

    public Metrics metrics() {
        return metrics;
    }

    /** Whether the server takes no more requests. */
    boolean isDraining() {
        return draining;
    }

    /** Waits until the server is closed. */
    void join() throws InterruptedException {
        server.join();
    }

    /** Takes no more requests, lets those that run end within the grace, and stops. */
    @Override
    public void close() {
        draining = true;
        try {
            server.stop();
        } catch (TimeoutException e) {
            LOG.info("Some transfers did not end within the grace and were cut.");
        } catch (Exception e) {
            throw new IllegalStateException("the server cannot be stopped", e);
        } finally {
            metrics.close();
        }
    }
}
