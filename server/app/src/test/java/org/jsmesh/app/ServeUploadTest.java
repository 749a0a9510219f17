package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A {@code jsm serve} that takes models, as a program of its own that is killed. */
@Timeout(180)
@Tag("slow")
class ServeUploadTest {
    private static final Path OCTOPUS = Path.of("../../models/octopus.ply");
    private static final String TOKEN = "0123456789abcdef0123456789abcdef";
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private final HttpClient client = HttpClient.newHttpClient();
    private Process process;
    private URI root;

    @AfterEach
    void stop() throws InterruptedException {
        if (process != null) process.destroyForcibly().waitFor();
    }

    private void serve() throws IOException {
        Path models = Files.createDirectories(folder.resolve("models"));
        Path tokens = Files.writeString(folder.resolve("tokens"), TOKEN + "\n");
        process = new ProcessBuilder(List.of(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-Xmx64m",
                        "-cp",
                        System.getProperty("java.class.path"),
                        Jsm.class.getName(),
                        "serve",
                        models.toString(),
                        "--port",
                        "0",
                        "--cache",
                        folder.resolve("cache").toString(),
                        "--upload-token-file",
                        tokens.toString()))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        BufferedReader out =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        root = URI.create(out.readLine());
    }

    private JsonNode status() throws Exception {
        HttpRequest request =
                HttpRequest.newBuilder(root.resolve("m/octopus/status")).build();
        return JSON.readTree(
                client.send(request, HttpResponse.BodyHandlers.ofString()).body());
    }

    private static boolean isEncoding(JsonNode status) {
        return status.path("state").asText().equals("encoding")
                && status.path("fraction").asDouble() > 0;
    }

    @Test
    void shouldGoOnWhereItWasKilledAndLeaveNoHalfFile() throws Exception {
        serve();
        HttpRequest send = HttpRequest.newBuilder(root.resolve("m/octopus?name=octopus.ply"))
                .header("Authorization", "Bearer " + TOKEN)
                .POST(HttpRequest.BodyPublishers.ofFile(OCTOPUS))
                .build();
        assertThat(client.send(send, HttpResponse.BodyHandlers.ofString()).statusCode())
                .isEqualTo(202);
        Await.until("the encoder to begin", () -> isEncoding(status()));
        List<ProcessHandle> encoders = process.children().toList();
        assertThat(encoders).hasSize(1);
        process.destroyForcibly().waitFor();
        // The process that encodes does not outlive the server.
        encoders.get(0).onExit().get(30, TimeUnit.SECONDS);
        Path uploads = folder.resolve("models/uploads");
        assertThat(uploads).isDirectoryNotContaining("glob:**.jsm");
        serve();
        awaitEnd();
        assertThat(status().path("state").asText()).isEqualTo("ready");
        Path out = folder.resolve("again.ply");
        Cli.ok("fetch", root.resolve("m/octopus/manifest.json"), "-o", out, "--full");
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh()))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(OCTOPUS).mesh()));
        try (Stream<Path> left = Files.list(uploads.resolve(".spool"))) {
            assertThat(left).isEmpty();
        }
    }

    @Test
    @Tag("long")
    void shouldGoOnWithAPartAfterItWasKilled() throws Exception {
        serve();
        byte[] bytes = Files.readAllBytes(OCTOPUS);
        HttpRequest create = tus(root.resolve("m/.uploads/"))
                .header("Upload-Length", "" + bytes.length)
                .header(
                        "Upload-Metadata",
                        "filename "
                                + Base64.getEncoder().encodeToString("octopus.ply".getBytes(StandardCharsets.US_ASCII)))
                .POST(HttpRequest.BodyPublishers.noBody())
                .build();
        HttpResponse<String> created = client.send(create, HttpResponse.BodyHandlers.ofString());
        assertThat(created.statusCode()).isEqualTo(201);
        URI upload =
                created.uri().resolve(created.headers().firstValue("Location").orElseThrow());
        int half = bytes.length / 2;
        // A part that stops in its middle, and while the server waits for the rest of it, the server is killed.
        try (Socket socket = new Socket(upload.getHost(), upload.getPort())) {
            String head = "PATCH " + upload.getPath() + " HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN
                    + "\r\nTus-Resumable: 1.0.0\r\nUpload-Offset: 0\r\nContent-Length: " + bytes.length
                    + "\r\nContent-Type: application/offset+octet-stream\r\n\r\n";
            socket.getOutputStream().write(head.getBytes(StandardCharsets.US_ASCII));
            for (int i = 0; i < half && offset(upload) == 0; i += 10_000) {
                socket.getOutputStream().write(bytes, i, Math.min(10_000, half - i));
                Thread.sleep(100);
            }
            Await.until("some of it to be on disk", () -> offset(upload) > 0);
            process.destroyForcibly().waitFor();
        }
        serve();
        URI again = root.resolve(upload.getPath());
        int from = offset(again);
        assertThat(from).isBetween(1, half);
        HttpRequest rest = tus(again)
                .header("Upload-Offset", "" + from)
                .header("Content-Type", "application/offset+octet-stream")
                .method("PATCH", HttpRequest.BodyPublishers.ofByteArray(bytes, from, bytes.length - from))
                .build();
        assertThat(client.send(rest, HttpResponse.BodyHandlers.ofString()).statusCode())
                .isEqualTo(204);
        awaitEnd();
        Path out = folder.resolve("again.ply");
        Cli.ok("fetch", root.resolve("m/octopus/manifest.json"), "-o", out, "--full");
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh()))
                .isEqualTo(MeshIdentity.sha256(ModelFiles.read(OCTOPUS).mesh()));
    }

    private static HttpRequest.Builder tus(URI address) {
        return HttpRequest.newBuilder(address)
                .version(HttpClient.Version.HTTP_1_1)
                .header("Authorization", "Bearer " + TOKEN)
                .header("Tus-Resumable", "1.0.0");
    }

    private int offset(URI upload) throws Exception {
        HttpRequest ask =
                tus(upload).method("HEAD", HttpRequest.BodyPublishers.noBody()).build();
        return Integer.parseInt(client.send(ask, HttpResponse.BodyHandlers.ofString())
                .headers()
                .firstValue("Upload-Offset")
                .orElseThrow());
    }

    @Test
    @Tag("long")
    void shouldEncodeAgainWhatWasToldToEndWithTheServer() throws Exception {
        serve();
        HttpRequest send = HttpRequest.newBuilder(root.resolve("m/octopus?name=octopus.ply"))
                .header("Authorization", "Bearer " + TOKEN)
                .POST(HttpRequest.BodyPublishers.ofFile(OCTOPUS))
                .build();
        assertThat(client.send(send, HttpResponse.BodyHandlers.ofString()).statusCode())
                .isEqualTo(202);
        Await.until("the encoder to begin", () -> isEncoding(status()));
        // As Ctrl+C and service managers do, which tell all processes of a group.
        process.children().toList().forEach(ProcessHandle::destroy);
        awaitEnd();
        assertThat(status().path("state").asText()).isEqualTo("ready");
    }

    private void awaitEnd() throws Exception {
        Await.until(
                "the model to be ready", () -> status().path("state").asText().matches("ready|failed"));
    }

    @Test
    void shouldHoldNoModelInMemory() throws Exception {
        serve();
        int bytes = 150_000_000; // more than twice the heap of the server
        InputStream zeros = new InputStream() {
            private int left = bytes;

            @Override
            public int read() {
                return left-- > 0 ? 0 : -1;
            }

            @Override
            public int read(byte[] array, int offset, int length) {
                int count = Math.min(left, length);
                left -= count;
                Arrays.fill(array, offset, offset + count, (byte) 0);
                return count > 0 ? count : -1;
            }
        };
        HttpRequest send = HttpRequest.newBuilder(root.resolve("m/octopus?name=zeros.stl"))
                .header("Authorization", "Bearer " + TOKEN)
                .POST(HttpRequest.BodyPublishers.ofInputStream(() -> zeros))
                .build();
        assertThat(client.send(send, HttpResponse.BodyHandlers.ofString()).statusCode())
                .isEqualTo(202);
        awaitEnd();
        assertThat(status().path("state").asText()).isEqualTo("failed");
        assertThat(process.isAlive()).isTrue();
    }

    @Test
    void shouldSayWhyItCannotTakeModels() throws IOException {
        Path models = Files.createDirectories(folder.resolve("models"));
        Path empty = Files.writeString(folder.resolve("tokens"), "# none\n");
        Cli cli = Cli.run("serve", models, "--port", "0", "--upload-token-file", empty);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains("tokens", "holds no token").hasLineCount(1);
        Files.writeString(empty, TOKEN);
        Path one = Bumpy.write(folder.resolve("one.ply"), 12);
        Cli single = Cli.run("serve", one, "--port", "0", "--upload-token-file", empty);
        assertThat(single.code()).isEqualTo(1);
        assertThat(single.err()).contains("one.ply").hasLineCount(1);
        Cli little = Cli.run("serve", models, "--port", "0", "--upload-token-file", empty, "--upload-memory", "1");
        assertThat(little.code()).isEqualTo(1);
        assertThat(little.err()).contains("MiB of the encoder: 1").hasLineCount(1);
    }
}
