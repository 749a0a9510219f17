package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jakarta.servlet.ServletContext;
import java.net.URI;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.eclipse.jetty.ee11.servlet.DefaultServlet;
import org.eclipse.jetty.ee11.servlet.ServletContextHandler;
import org.eclipse.jetty.ee11.servlet.ServletHolder;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.jsmesh.servlet.testing.TestServer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class JettyHostTest extends HostContract {
    private final Server jetty = new Server();

    @Override
    TestServer start(String contextPath, Consumer<ServletContext> guest) throws Exception {
        ServerConnector connector = new ServerConnector(jetty, 1, 1);
        connector.setHost("127.0.0.1");
        jetty.setConnectors(new ServerConnector[] {connector});
        ServletContextHandler context = new ServletContextHandler(contextPath.isEmpty() ? "/" : contextPath);
        context.setBaseResourceAsPath(Path.of("src/test/resources/static").toAbsolutePath());
        context.setWelcomeFiles(new String[] {"index.html"});
        context.addServlet(new ServletHolder("default", new DefaultServlet()), "/");
        context.addServlet(new ServletHolder("about", new AboutPage()), "/about");
        context.addServletContainerInitializer((classes, application) -> guest.accept(application));
        jetty.setHandler(context);
        jetty.start();
        return new TestServer() {
            @Override
            public URI root() {
                return URI.create("http://127.0.0.1:" + connector.getLocalPort() + contextPath + "/");
            }

            @Override
            public void stop() throws Exception {
                jetty.stop();
            }
        };
    }

    /** Also what did not start. */
    @AfterEach
    void stopJetty() throws Exception {
        jetty.stop();
    }

    @Test
    void shouldServeAgainWhenTheServletIsStartedAgain() throws Exception {
        StreamingServlet models = models();
        for (int i = 0; i < 2; i++) {
            server = start("", application -> models.mount(application, "/models/*"));
            assertServes(server.root().resolve("models/"));
            server.stop();
        }
    }

    @Test
    void shouldServeWhatIsAddedByAHolder() throws Exception {
        StreamingServlet models = models();
        server = start("", application -> {
            ServletContextHandler context =
                    ServletContextHandler.getServletContextHandler(application, "of this application");
            context.addServlet(new ServletHolder(models), "/models/*");
        });
        assertServes(server.root().resolve("models/"));
    }

    @Test
    void shouldNotStartWithOneServletAtTwoPlaces() throws Exception {
        StreamingServlet models = models();
        assertThatThrownBy(() -> start("", application -> {
                    models.mount(application, "/models/*");
                    models.mount(application, "/more/*");
                }))
                .hasStackTraceContaining("make a StreamingServlet for every place");
    }

    @Test
    void shouldNotStartWithoutModels() {
        Path nowhere = folder.resolve("nowhere");
        StreamingServlet models = new StreamingServlet(nowhere);
        assertThatThrownBy(() -> start("", application -> models.mount(application, "/models/*")))
                .hasStackTraceContaining(nowhere + ": no such file. Check the path.");
    }
}
