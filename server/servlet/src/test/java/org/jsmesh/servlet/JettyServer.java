package org.jsmesh.servlet;

import java.net.URI;
import org.eclipse.jetty.ee11.servlet.ServletContextHandler;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.jsmesh.store.ModelStore;

/** The application in an embedded Jetty. */
final class JettyServer implements TestServer {
    /** Short, so that tests can outlast it. */
    static final int IDLE_MILLIS = 1000;

    private final Server server = new Server();
    private final ServerConnector connector = new ServerConnector(server, 1, 1);

    JettyServer(ModelStore store) throws Exception {
        connector.setHost("127.0.0.1");
        connector.setIdleTimeout(IDLE_MILLIS);
        server.addConnector(connector);
        ServletContextHandler context = new ServletContextHandler("/");
        context.addServletContainerInitializer(
                (classes, application) -> StreamingApplication.install(application, store, ServletSettings.defaults()));
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
