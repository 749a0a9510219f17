package org.jsmesh.app;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.eclipse.jetty.alpn.server.ALPNServerConnectionFactory;
import org.eclipse.jetty.ee11.servlet.ServletContextHandler;
import org.eclipse.jetty.http2.server.HTTP2ServerConnectionFactory;
import org.eclipse.jetty.server.ConnectionFactory;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.SecureRequestCustomizer;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.server.SslConnectionFactory;
import org.eclipse.jetty.server.handler.StatisticsHandler;
import org.eclipse.jetty.util.ssl.SslContextFactory;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.jsmesh.servlet.ServletSettings;
import org.jsmesh.servlet.StreamingApplication;
import org.jsmesh.store.ModelStore;

/**
 * A Jetty that serves a store: HTTP/1.1 and HTTP/2 on one port, without encryption (h2c with prior knowledge) or, with a keystore, with TLS (h2 by ALPN).
 * Thread-safe.
 */
final class JsmServer implements AutoCloseable {
    /** Long enough for people to look at a model between two rounds on one connection. */
    private static final long IDLE_MILLIS = 120_000;

    /** Held, because a logger that nobody holds forgets its level. */
    private static final Logger JETTY_LOG = Logger.getLogger("org.eclipse.jetty");

    private final Server server;
    private final ServerConnector connector;
    private final StatisticsHandler statistics = new StatisticsHandler();
    private final boolean encrypted;

    private JsmServer(ServerSettings settings, ModelStore store) {
        JETTY_LOG.setLevel(Level.WARNING);
        QueuedThreadPool threads = new QueuedThreadPool();
        threads.setName("jsm-http");
        server = new Server(threads);
        encrypted = settings.keystore() != null;
        connector = new ServerConnector(server, encrypted ? encrypted(settings) : plain());
        connector.setHost(settings.host());
        connector.setPort(settings.port());
        connector.setIdleTimeout(IDLE_MILLIS);
        server.addConnector(connector);
        ServletContextHandler context = new ServletContextHandler("/");
        context.addServletContainerInitializer(
                (classes, application) -> StreamingApplication.install(application, store, ServletSettings.defaults()));
        context.setErrorHandler(new ShortErrors());
        server.setErrorHandler(new ShortErrors());
        statistics.setHandler(context);
        server.setHandler(statistics);
    }

    /**
     * Starts a server.
     *
     * @param store which the caller closes after the server
     * @throws IOException when the address cannot be listened at or the keystore cannot be read
     */
    static JsmServer start(ServerSettings settings, ModelStore store) throws IOException {
        if (settings.keystore() != null && !Files.isReadable(settings.keystore())) {
            throw new NoSuchFileException(settings.keystore().toString());
        }
        JsmServer started = new JsmServer(settings, store);
        try {
            started.server.start();
            return started;
        } catch (Exception e) {
            started.close();
            if (e instanceof IOException io) throw io;
            throw new IOException(e.getMessage(), e);
        }
    }

    private static ConnectionFactory[] plain() {
        HttpConfiguration http = http();
        return new ConnectionFactory[] {new HttpConnectionFactory(http), new PriorKnowledgeHttp2(http)};
    }

    private static ConnectionFactory[] encrypted(ServerSettings settings) {
        HttpConfiguration http = http();
        // The name in the certificate need not be the one that a proxy or a test calls the server by.
        http.addCustomizer(new SecureRequestCustomizer(false));
        SslContextFactory.Server tls = new SslContextFactory.Server();
        tls.setKeyStorePath(settings.keystore().toString());
        tls.setKeyStorePassword(settings.keystorePassword());
        ALPNServerConnectionFactory alpn = new ALPNServerConnectionFactory();
        alpn.setDefaultProtocol("http/1.1");
        SslConnectionFactory ssl = new SslConnectionFactory(tls, alpn.getProtocol());
        return new ConnectionFactory[] {
            ssl, alpn, new HTTP2ServerConnectionFactory(http), new HttpConnectionFactory(http)
        };
    }

    private static HttpConfiguration http() {
        HttpConfiguration http = new HttpConfiguration();
        http.setSendServerVersion(false);
        return http;
    }

    /** Where the page is, with a name that a browser on this machine can open; ends with a slash. */
    URI uri() {
        String host = connector.getHost();
        boolean everywhere = host == null || host.equals("0.0.0.0") || host.equals("::");
        String name = everywhere ? "localhost" : host.contains(":") ? "[" + host + "]" : host;
        return URI.create((encrypted ? "https://" : "http://") + name + ":" + connector.getLocalPort() + "/");
    }

    /** What the server has answered so far. */
    StatisticsHandler statistics() {
        return statistics;
    }

    /** Waits until the server is closed. */
    void join() throws InterruptedException {
        server.join();
    }

    @Override
    public void close() {
        try {
            server.stop();
        } catch (Exception e) {
            throw new IllegalStateException("the server cannot be stopped", e);
        }
    }
}
