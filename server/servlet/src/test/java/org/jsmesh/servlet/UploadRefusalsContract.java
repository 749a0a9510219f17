package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What every container has to refuse when clients send models, and to survive. */
abstract class UploadRefusalsContract extends UploadFixture {
    @Test
    void shouldAskWhoSends() throws Exception {
        open();
        HttpRequest.Builder nobody = HttpRequest.newBuilder(server.root().resolve("m/bench"));
        HttpResponse<byte[]> answer = send(nobody, ply(4));
        assertRefused(answer, 401, "token");
        assertThat(answer.headers().firstValue("WWW-Authenticate")).contains("Bearer");
        answer = send(post("m/bench").setHeader("Authorization", "Bearer " + TOKEN + "0"), ply(4));
        assertRefused(answer, 401, "token");
        assertThat(answer.headers().firstValue("WWW-Authenticate").orElse("")).contains("invalid_token");
        assertRefused(send(post("m/bench").setHeader("Authorization", "Basic " + TOKEN), ply(4)), 401, "token");
        assertRefused(send(post("m/bench").setHeader("Authorization", "Bearer " + CHAIRS), ply(4)), 403, "bench");
        JsonNode chair = await(send(post("m/chair-1").setHeader("Authorization", "Bearer " + CHAIRS), ply(4)));
        assertThat(chair.get("state").asText()).isEqualTo("ready");
    }

    @ParameterizedTest
    @CsvSource({"a--b, 400", "-a, 400", "a-, 400", "stool, 409"})
    void shouldRefuseIds(String id, int status) throws Exception {
        open();
        assertRefused(send(post("m/" + id), ply(4)), status, id);
    }

    @Test
    void shouldNotTakeModelsThatWouldNotGetTheirId() throws Exception {
        for (String name : new String[] {"a", "b"})
            Files.writeString(Files.createDirectory(models.resolve(name)).resolve("bunny.ply"), ply(4));
        open();
        assertRefused(send(post("m/bunny"), ply(4)), 409, "bunny");
    }

    @ParameterizedTest
    @CsvSource({"m/, 405", "m/Bench, 405", "m/bench/manifest.json, 405", "m/a/b/c, 405", "m/..%2fx, 400"})
    void shouldTakeModelsNowhereElse(String path, int status) throws Exception {
        open();
        assertThat(send(post(path), ply(4)).statusCode()).isIn(status, 400);
        assertNothingIsLeft();
    }

    @Test
    void shouldRefuseWhatIsNoModel() throws Exception {
        open();
        assertRefused(send(post("m/bench").header("Content-Type", "text/html"), "<p>"), 415, "no model");
        assertRefused(send(post("m/bench?name=x.exe"), "MZ"), 415, "no model");
        assertRefused(
                send(post("m/bench").header("Content-Disposition", "attachment; filename=\"x.php\""), "<?"),
                415,
                "no model");
        assertRefused(send(post("m/bench"), ""), 422, "empty");
        JsonNode status = await(send(post("m/bench").header("Content-Type", "model/ply"), "ply\nnonsense\n"));
        assertThat(status.get("state").asText()).isEqualTo("failed");
        assertThat(status.get("error").asText()).contains("cannot be read");
        assertThat(status.get("remedy").asText()).isNotEmpty();
        assertThat(status.toString()).doesNotContain(folder.toString());
        assertThat(get(server.root().resolve("m/bench/manifest.json")).statusCode())
                .isEqualTo(404);
    }

    @Test
    void shouldRefuseWhatIsTooLarge() throws Exception {
        open();
        String head = "POST /m/bench HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN + "\r\n";
        // Nothing of the body is waited for.
        assertThat(raw(head + "Content-Length: 99999999999\r\n\r\n")).startsWith("HTTP/1.1 413 ");
        assertThat(raw(head + "\r\n")).startsWith("HTTP/1.1 411 ");
        StringBuilder chunks = new StringBuilder(head + "Transfer-Encoding: chunked\r\n\r\n");
        for (int i = 0; i < 30; i++)
            chunks.append("2000\r\n").append("x".repeat(0x2000)).append("\r\n");
        assertThat(raw(chunks.toString())).startsWith("HTTP/1.1 413 ");
        assertNothingIsLeft();
        JsonNode status = await(send(post("m/bench"), ply(60)));
        assertThat(status.get("error").asText()).contains("6962 faces", "5000");
    }

    /** Sends all, and reads until the server closes or an answer has come. */
    private String raw(String request) throws IOException {
        try (Socket socket = new Socket("127.0.0.1", server.root().getPort())) {
            socket.setSoTimeout(10_000);
            OutputStream out = socket.getOutputStream();
            out.write(request.getBytes(StandardCharsets.ISO_8859_1));
            out.flush();
            byte[] head = new byte[64];
            InputStream in = socket.getInputStream();
            int count = in.read(head);
            return count < 0 ? "" : new String(head, 0, count, StandardCharsets.ISO_8859_1);
        }
    }

    @Test
    void shouldSurviveHostileFiles() throws Exception {
        settings = settings.withEncodeMillis(20_000);
        open();
        String[] hostile = {
            // More vertices than there is memory for, and more than there are bytes.
            "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n" + "1\n".repeat(90_000),
            "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + "[".repeat(90_000) + "}",
            "OFF\n3 1000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
            "\0".repeat(MOST_BYTES)
        };
        String[] names = {"x.ply", "x.ply", "x.gltf", "x.off", "x.stl"};
        for (int i = 0; i < hostile.length; i++) {
            JsonNode status = await(send(post("m/bad-" + i + "?name=" + names[i]), hostile[i]));
            assertThat(status.get("state").asText()).as(names[i] + " " + i).isEqualTo("failed");
            assertThat(status.get("error").asText()).isNotEmpty().doesNotContain("Exception", folder.toString());
            // Its own encoding may not be over.
            assertThat(get(server.root().resolve("m/stool/manifest.json")).statusCode())
                    .isIn(200, 202);
        }
        assertNothingIsLeft();
        assertThat(models.resolve("uploads")).isDirectoryNotContaining("glob:**.jsm");
    }
}
