package org.jsmesh.desktop.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.desktop.StartedViewer;
import org.jsmesh.test.Await;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The desktop's own tools, in a home of their own: what they start shows the model. */
class LinkHandlerIT {
    @TempDir
    private Path folder;

    private Path open;
    private HttpServer server;
    private StartedViewer viewer;
    private Map<String, String> home;

    @BeforeEach
    void start() throws IOException {
        open = Requirement.xdg();
        Requirement.display();
        server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
        byte[] archive = Files.readAllBytes(StartedViewer.torus(folder));
        server.createContext("/torus.jsm", exchange -> {
            exchange.sendResponseHeaders(200, archive.length);
            exchange.getResponseBody().write(archive);
            exchange.close();
        });
        server.start();
        home = Map.of(
                "HOME", folder.resolve("home").toString(),
                "XDG_DATA_HOME", folder.resolve("home/share").toString(),
                "XDG_CONFIG_HOME", folder.resolve("home/config").toString(),
                "XDG_CACHE_HOME", folder.resolve("home/cache").toString(),
                "XDG_CURRENT_DESKTOP", "",
                "DESKTOP_SESSION", "",
                "BROWSER", "");
        // A path that no shell takes for one word.
        Path jar = Files.createDirectories(folder.resolve("its own folder")).resolve("jsm-viewer.jar");
        Files.copy(Path.of("target", "jsm-viewer.jar"), jar);
        viewer = new StartedViewer(List.of(StartedViewer.java(), "-jar", jar.toString()), folder, home);
    }

    @AfterEach
    void stop() {
        if (server != null) server.stop(0);
    }

    @Test
    void shouldShowAModelFromALink() throws Exception {
        assertThat(viewer.run(0, "--register")).contains("jsm: links and .jsm files are opened with", "jsm-viewer.jar");
        assertThat(defaultOf("x-scheme-handler/jsm")).isEqualTo("jsm-viewer.desktop");
        assertThat(defaultOf("model/vnd.jsm")).isEqualTo("jsm-viewer.desktop");
        String address = "http://127.0.0.1:" + server.getAddress().getPort() + "/torus.jsm";
        Process opened = begin(open.toString(), "jsm:" + address);
        try {
            Await.until("the model on the screen", Screen::showsManyColours);
            Screen.keep("from-a-link");
        } finally {
            opened.descendants().forEach(ProcessHandle::destroyForcibly);
            opened.destroyForcibly();
        }
        assertThat(opened.waitFor(60, TimeUnit.SECONDS)).isTrue();

        viewer.run(0, "--unregister");
        assertThat(defaultOf("x-scheme-handler/jsm")).isEmpty();
        try (Stream<Path> left = Files.walk(folder.resolve("home"))) {
            assertThat(left.filter(Files::isRegularFile)
                            .filter(file -> file.getFileName().toString().matches(".*jsm.*viewer.*")))
                    .isEmpty();
        }
        // Nothing more to take back.
        viewer.run(0, "--unregister");
    }

    private String defaultOf(String type) throws Exception {
        Process query = begin("xdg-mime", "query", "default", type);
        assertThat(query.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return Files.readString(folder.resolve("tool.txt"), StandardCharsets.UTF_8)
                .strip();
    }

    private Process begin(String... command) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("tool.txt").toFile());
        builder.environment().putAll(home);
        return builder.start();
    }
}
