package org.jsmesh.servlet;

import java.net.URI;
import org.eclipse.jetty.ee11.servlet.ServletContextHandler;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.jsmesh.store.ModelStore;

/** The application in an embedded Jetty. */
final class JettyServer implements TestServer {
    static final int IDLE_MILLIS = 60_000;

    private final Server server = new Server(new QueuedThreadPool(THREADS));
    private final ServerConnector connector = new ServerConnector(server, 1, 1);

    JettyServer(ModelStore store) throws Exception {
        this(store, ServletSettings.defaults(), IDLE_MILLIS);
    }

    JettyServer(ModelStore store, ServletSettings settings, int idleMillis) throws Exception {
        connector.setHost("127.0.0.1");
        connector.setIdleTimeout(idleMillis);
        server.addConnector(connector);
        ServletContextHandler context = new ServletContextHandler("/");
        context.addServletContainerInitializer((classes, application) -> {
            FailingWrites.install(application);
            StreamingApplication.install(application, store, settings);
        });
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
