package org.jsmesh.servlet.testing;

import jakarta.servlet.ServletContext;
import java.net.URI;
import java.util.function.Consumer;
import org.eclipse.jetty.ee11.servlet.ServletContextHandler;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.thread.QueuedThreadPool;

/** An embedded Jetty. */
public final class JettyServer implements TestServer {
    private static final int IDLE_MILLIS = 60_000;

    private final Server server = new Server(new QueuedThreadPool(THREADS));
    private final ServerConnector connector = new ServerConnector(server, 1, 1);

    /** @param application puts in what the application has */
    public JettyServer(Consumer<ServletContext> application) throws Exception {
        this(application, IDLE_MILLIS);
    }

    public JettyServer(Consumer<ServletContext> application, int idleMillis) throws Exception {
        connector.setHost("127.0.0.1");
        connector.setIdleTimeout(idleMillis);
        server.addConnector(connector);
        ServletContextHandler context = new ServletContextHandler("/");
        context.addServletContainerInitializer((classes, started) -> application.accept(started));
        server.setHandler(context);
        server.start();
    }

    @Override
    public URI root() {
        return URI.create("http://127.0.0.1:" + connector.getLocalPort() + "/");
    }

    @Override
    public void stop() throws Exception {
        server.stop();
    }
}
