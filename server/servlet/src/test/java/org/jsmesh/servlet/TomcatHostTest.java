package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jakarta.servlet.ServletContext;
import java.net.URI;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.apache.catalina.Context;
import org.apache.catalina.servlets.DefaultServlet;
import org.apache.catalina.startup.Tomcat;
import org.jsmesh.servlet.testing.TestServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TomcatHostTest extends HostContract {
    /** Held, because loggers that nobody holds forget their level. */
    private static final Logger TOMCAT_LOG = Logger.getLogger("org.apache");

    @Override
    TestServer start(String contextPath, Consumer<ServletContext> guest) throws Exception {
        return start(contextPath, guest, context -> {});
    }

    private TestServer start(String contextPath, Consumer<ServletContext> guest, Consumer<Context> more)
            throws Exception {
        TOMCAT_LOG.setLevel(Level.SEVERE);
        Tomcat tomcat = new Tomcat();
        tomcat.setBaseDir(folder.resolve("tomcat").toString());
        tomcat.setHostname("127.0.0.1");
        tomcat.setPort(0);
        tomcat.getConnector().setProperty("address", "127.0.0.1");
        Path pages = Path.of("src/test/resources/static").toAbsolutePath();
        Context context = tomcat.addContext(contextPath, pages.toString());
        context.addWelcomeFile("index.html");
        context.addMimeMapping("html", "text/html");
        Tomcat.addServlet(context, "default", new DefaultServlet()).addMapping("/");
        Tomcat.addServlet(context, "about", new AboutPage()).addMapping("/about");
        context.addServletContainerInitializer((classes, application) -> guest.accept(application), null);
        more.accept(context);
        tomcat.start();
        return new TestServer() {
            @Override
            public URI root() {
                return URI.create("http://127.0.0.1:" + tomcat.getConnector().getLocalPort() + contextPath + "/");
            }

            @Override
            public void stop() throws Exception {
                tomcat.stop();
                tomcat.destroy();
            }
        };
    }

    @Test
    void shouldSayInTheLogWhenRequestsCannotBeAsynchronous() throws Exception {
        StreamingServlet models = models();
        List<String> messages = new ArrayList<>();
        Logger log = Logger.getLogger(StreamingServlet.class.getName());
        Handler handler = new Handler() {
            @Override
            public void publish(LogRecord record) {
                messages.add(record.getThrown().getMessage());
            }

            @Override
            public void flush() {
                // Nothing is kept back.
            }

            @Override
            public void close() {
                // Nothing is open.
            }
        };
        log.addHandler(handler);
        log.setLevel(Level.ALL);
        log.setUseParentHandlers(false);
        try {
            server = start(
                    "",
                    application -> {},
                    context -> Tomcat.addServlet(context, "models", models).addMapping("/models/*"));
            HttpResponse<byte[]> answer = get(server.root().resolve("models/index.json"));
            assertThat(answer.statusCode()).isEqualTo(500);
            assertThat(new String(answer.body(), StandardCharsets.UTF_8)).contains("see the server's log");
            assertThat(messages).singleElement().asString().contains("models", "setAsyncSupported(true)");
        } finally {
            log.removeHandler(handler);
            log.setUseParentHandlers(true);
            log.setLevel(null);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"models/*", "/models", "*.jsm", "", "/models/"})
    void shouldRefuseWhatIsNoPlaceForModels(String pattern) throws Exception {
        StreamingServlet models = models();
        server = start(
                "",
                application -> assertThatThrownBy(() -> models.mount(application, pattern))
                        .isInstanceOf(IllegalArgumentException.class)
                        .hasMessageContaining("'" + pattern + "'")
                        .hasMessageContaining("/models/*"));
    }

    @Test
    void shouldRefuseThePlaceOfAnother() throws Exception {
        StreamingServlet models = models();
        StreamingServlet others = models();
        server = start("", application -> {
            models.mount(application, "/models/*");
            assertThatThrownBy(() -> others.mount(application, "/models/*")).hasMessageContaining("/models/*");
            application.addServlet("shop", new AboutPage()).addMapping("/shop/*");
            assertThatThrownBy(() -> others.mount(application, "/shop/*"))
                    .hasMessageContaining("/shop/* is another servlet's");
        });
        assertServes(server.root().resolve("models/"));
    }
}
