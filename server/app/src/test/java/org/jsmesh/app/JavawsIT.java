package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The desktop viewer as the page starts it: {@code jsm.jar} serves the signed copy beside it, a program for JNLP reads
 * what the server says of a model, loads the viewer from the server, and the viewer draws the model.
 */
@Timeout(300)
class JavawsIT {
    private static final Path TARGET = Path.of("target");
    private static final int SECONDS = 120;
    private static final int SHOWN_PIXELS = 5_000;

    @TempDir
    private Path folder;

    @Test
    void shouldDrawTheModelThatTheServerNames() throws Exception {
        Path javaws = Requirement.javaws();
        Requirement.display();
        Path models = Files.createDirectory(folder.resolve("models"));
        Files.writeString(models.resolve("A & B.ply"), Bumpy.torus(90));
        Process server = new ProcessBuilder(
                        java(),
                        "-jar",
                        TARGET.resolve("jsm.jar").toString(),
                        "serve",
                        models.toString(),
                        "--port",
                        "0",
                        "--cache",
                        folder.resolve("cache").toString())
                .redirectError(folder.resolve("server.txt").toFile())
                .start();
        try (BufferedReader said = server.inputReader()) {
            URI root = URI.create(said.readLine());
            HttpResponse<String> answer = HttpClient.newHttpClient()
                    .send(
                            HttpRequest.newBuilder(root.resolve("m/a-b/viewer.jnlp"))
                                    .build(),
                            HttpResponse.BodyHandlers.ofString());
            assertThat(answer.statusCode()).isEqualTo(200);
            // The text as the browser saves it, but that the viewer shall draw into a file instead of a window.
            StringBuilder more = new StringBuilder("</argument>");
            for (String argument : arguments("started.png"))
                more.append("<argument>").append(argument).append("</argument>");
            Path launch =
                    Files.writeString(folder.resolve("a-b.jnlp"), answer.body().replace("</argument>", more));
            run(List.of(javaws.toString(), "-Xtrustall", "-Xnofork", launch.toString()));
            List<String> plain = new ArrayList<>(
                    List.of(java(), "-jar", TARGET.resolve("jsm-viewer.jar").toString()));
            plain.add(root.resolve("m/a-b/manifest.json").toString());
            plain.addAll(arguments("plain.png"));
            run(plain);
        } finally {
            server.destroy();
            assertThat(server.waitFor(SECONDS, TimeUnit.SECONDS)).isTrue();
        }
        BufferedImage picture = ImageIO.read(folder.resolve("started.png").toFile());
        int shown = 0;
        for (int i = 0; i < 320 * 240; i++) if (picture.getRGB(i % 320, i / 320) >>> 24 > 0) shown++;
        assertThat(shown).isGreaterThan(SHOWN_PIXELS);
        assertThat(Files.readAllBytes(folder.resolve("started.png")))
                .isEqualTo(Files.readAllBytes(folder.resolve("plain.png")));
    }

    private static String java() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    private List<String> arguments(String png) {
        return List.of(
                "--original",
                "--transparent",
                "--no-cache",
                "--size",
                "320x240",
                "--screenshot",
                folder.resolve(png).toString());
    }

    private void run(List<String> command) throws IOException, InterruptedException {
        Path log = folder.resolve("log.txt");
        ProcessBuilder builder =
                new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile());
        builder.environment()
                .put("XDG_CONFIG_HOME", folder.resolve("configuration").toString());
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("kept").toString());
        Process process = builder.start();
        boolean ended = process.waitFor(SECONDS, TimeUnit.SECONDS);
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        String output = Files.readString(log);
        assertThat(ended).as(output).isTrue();
        assertThat(process.exitValue()).as(output).isZero();
    }
}
