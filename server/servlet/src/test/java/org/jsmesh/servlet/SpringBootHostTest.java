package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jakarta.servlet.ServletContext;
import java.net.URI;
import java.nio.file.Path;
import java.util.Map;
import java.util.function.Consumer;
import org.jsmesh.servlet.testing.TestServer;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.springframework.boot.SpringApplication;
import org.springframework.boot.autoconfigure.EnableAutoConfiguration;
import org.springframework.boot.web.server.context.WebServerApplicationContext;
import org.springframework.boot.web.servlet.ServletContextInitializer;
import org.springframework.boot.web.servlet.ServletRegistrationBean;
import org.springframework.context.ConfigurableApplicationContext;
import org.springframework.context.annotation.Configuration;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.RestController;

class SpringBootHostTest extends HostContract {
    /** The host: its front page is {@code static/index.html}, as everywhere with Spring Boot. */
    @Configuration(proxyBeanMethods = false)
    @EnableAutoConfiguration
    @RestController
    static class Host {
        @GetMapping("/about")
        ResponseEntity<String> about() {
            return ResponseEntity.ok().header("X-Host", "the host's own").body(ABOUT);
        }
    }

    /** Spring Boot would set up the loggers of the whole process. */
    @BeforeAll
    static void leaveLoggersAlone() {
        System.setProperty("org.springframework.boot.logging.LoggingSystem", "none");
    }

    @Override
    TestServer start(String contextPath, Consumer<ServletContext> guest) {
        return run(contextPath, guest::accept);
    }

    private static TestServer run(String contextPath, ServletContextInitializer bean) {
        SpringApplication application = new SpringApplication(Host.class);
        application.setDefaultProperties(Map.of(
                "server.address", "127.0.0.1",
                "server.port", "0",
                "server.servlet.context-path", contextPath,
                "spring.main.banner-mode", "off"));
        application.addInitializers(context -> context.getBeanFactory().registerSingleton("models", bean));
        ConfigurableApplicationContext context = application.run();
        int port = ((WebServerApplicationContext) context).getWebServer().getPort();
        return new TestServer() {
            @Override
            public URI root() {
                return URI.create("http://127.0.0.1:" + port + contextPath + "/");
            }

            @Override
            public void stop() {
                context.close();
            }
        };
    }

    @Test
    void shouldServeWhatIsRegisteredByABean() throws Exception {
        server = run("/shop", new ServletRegistrationBean<>(models(), "/models/*"));
        assertServes(server.root().resolve("models/"));
    }

    @Test
    void shouldNotStartWithoutModels() {
        Path nowhere = folder.resolve("nowhere");
        StreamingServlet models = new StreamingServlet(nowhere);
        assertThatThrownBy(() -> run("", application -> models.mount(application, "/models/*")))
                .hasStackTraceContaining(nowhere + ": no such file. Check the path.");
    }
}
