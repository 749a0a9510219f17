package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.test.Await;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The desktop viewer as the page starts it: {@code jsm.jar} serves the signed copy beside it, a program for JNLP reads
 * what the server says of a model, loads the viewer from the server, and the viewer loads the model, which it does with
 * OpenGL alone. A text that adds an option is refused.
 */
@Timeout(300)
class JavawsIT {
    private static final Path TARGET = Path.of("target");
    private static final int SECONDS = 120;

    @TempDir
    private Path folder;

    @Test
    void shouldLoadTheModelThatTheServerNamesAndTakeNoOption() throws Exception {
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
            start(javaws, answer.body(), () -> keptArchives() == 1);
            String picture = folder.resolve("made.png").toString();
            String other = answer.body()
                    .replace("<argument>--</argument>", "<argument>--screenshot=" + picture + "</argument>");
            assertThat(other).contains(picture);
            start(javaws, other, () -> log().contains("did not match the launching JNLP file"));
            assertThat(Path.of(picture)).doesNotExist();
        } finally {
            server.destroy();
            assertThat(server.waitFor(SECONDS, TimeUnit.SECONDS)).isTrue();
        }
    }

    private static String java() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    /** The archives that viewers have kept. */
    private long keptArchives() throws IOException {
        Path kept = folder.resolve("kept/jsm");
        if (!Files.isDirectory(kept)) return 0;
        try (Stream<Path> found = Files.walk(kept)) {
            return found.filter(Files::isRegularFile)
                    .filter(file -> file.toFile().length() > 0)
                    .limit(1)
                    .count();
        }
    }

    private String log() throws IOException {
        return Files.readString(folder.resolve("log.txt"));
    }

    /** Starts what the text says, until something is seen of it. */
    private void start(Path javaws, String text, Await.Condition seen) throws Exception {
        Path launch = Files.writeString(folder.resolve("a-b.jnlp"), text);
        ProcessBuilder builder = new ProcessBuilder(javaws.toString(), "-Xtrustall", "-Xnofork", launch.toString())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("log.txt").toFile());
        builder.environment()
                .put("XDG_CONFIG_HOME", folder.resolve("configuration").toString());
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("kept").toString());
        // Its words are English then.
        builder.environment().put("LC_ALL", "C");
        Process process = builder.start();
        try {
            Await.until("what is seen of javaws", seen);
        } finally {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly().waitFor();
        }
    }
}
