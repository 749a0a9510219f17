package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayInputStream;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;

/** What every container has to do with models that clients send. */
abstract class UploadContract extends UploadFixture {
    @Test
    void shouldEncodeWhatIsSentAndServeIt() throws Exception {
        open();
        HttpRequest asking = HttpRequest.newBuilder(server.root().resolve("m/bench"))
                .method("OPTIONS", HttpRequest.BodyPublishers.noBody())
                .build();
        assertThat(client.send(asking, HttpResponse.BodyHandlers.discarding())
                        .headers()
                        .firstValue("Allow"))
                .contains("GET, HEAD, OPTIONS, POST, DELETE");
        JsonNode status = await(send(post("m/bench").header("Content-Type", "model/ply"), ply(30)));
        assertThat(status.get("state").asText()).as(status.toString()).isEqualTo("ready");
        URI manifest =
                server.root().resolve("m/bench/" + status.get("manifestUrl").asText());
        JsonNode described = JSON.readTree(get(manifest).body());
        assertThat(described.get("name").asText()).isEqualTo("bench");
        byte[] archive =
                get(manifest.resolve(described.get("archiveUrl").asText())).body();
        Path original = Files.writeString(folder.resolve("original.ply"), ply(30));
        assertThat(MeshIdentity.sha256(ArchiveFile.of(archive).original(ProgressListener.NONE)))
                .isEqualTo(MeshIdentity.sha256(
                        org.jsmesh.files.ModelFiles.read(original).mesh()));
        assertNothingIsLeft();
        // Sent again it is replaced, and who holds the old one learns of it.
        await(send(post("m/bench?name=bench.ply"), ply(20)));
        assertThat(get(manifest.resolve(described.get("archiveUrl").asText())).statusCode())
                .isEqualTo(404);
        assertThat(JSON.readTree(get(manifest).body()).get("faces").asInt()).isEqualTo(2 * 19 * 19);
    }

    /** The process that encodes gives nothing back but the archive, which has the notes. */
    @Test
    void shouldTellWhatOfTheModelIsNotInItsArchive() throws Exception {
        open();
        String obj =
                "mtllib gone.mtl\ng wheel\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
        JsonNode status = await(send(post("m/bench?name=bench.obj"), obj));
        assertThat(status.get("state").asText()).as(status.toString()).isEqualTo("ready");
        assertThat(status.get("notes")).anySatisfy(note -> {
            assertThat(note.get("text").asText()).startsWith("Material libraries not found: gone.mtl.");
            assertThat(note.get("warning").asBoolean()).isTrue();
        });
        JsonNode manifest = JSON.readTree(
                get(server.root().resolve("m/bench/manifest.json")).body());
        assertThat(manifest.get("notes")).isEqualTo(status.get("notes"));
        assertThat(manifest.get("sourceFormat").asText()).isEqualTo("OBJ");
    }

    @Test
    void shouldTakeBodiesWithoutALength() throws Exception {
        open();
        HttpRequest.BodyPublisher chunked = HttpRequest.BodyPublishers.ofInputStream(
                () -> new ByteArrayInputStream(ply(10).getBytes(StandardCharsets.UTF_8)));
        HttpRequest request = post("m/bench").POST(chunked).build();
        JsonNode status = await(client.send(request, HttpResponse.BodyHandlers.ofByteArray()));
        assertThat(status.get("state").asText()).as(status.toString()).isEqualTo("ready");
    }

    @Test
    void shouldTellWhereTheModelIsWhenFilesHaveComeInItsWay() throws Exception {
        open();
        HttpResponse<byte[]> accepted = send(post("m/bench"), ply(5));
        assertThat(await(accepted).get("manifestUrl").asText()).isEqualTo("manifest.json");
        Files.writeString(models.resolve("bench.ply"), ply(4));
        store.list(); // looks at once
        JsonNode status = await(accepted);
        URI manifest =
                server.root().resolve("m/bench/" + status.get("manifestUrl").asText());
        assertThat(JSON.readTree(get(manifest).body()).get("faces").asInt()).isEqualTo(2 * 4 * 4);
    }

    @Test
    void shouldForgetABodyThatEndsEarly() throws Exception {
        open();
        try (Socket socket = new Socket("127.0.0.1", server.root().getPort())) {
            String text = ply(10);
            String head = "POST /m/bench HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN + "\r\nContent-Length: "
                    + text.length() + "\r\n\r\n";
            socket.getOutputStream().write((head + text.substring(0, 1000)).getBytes(StandardCharsets.ISO_8859_1));
            socket.getOutputStream().flush();
            Await.until("the upload to begin", () -> store.uploads().length() > 0);
        }
        Await.until("an empty queue", () -> store.uploads().length() == 0);
        assertNothingIsLeft();
        assertThat(get(server.root().resolve("m/bench/status")).statusCode()).isEqualTo(404);
    }

    @Test
    void shouldSayThatTheQueueIsFull() throws Exception {
        open();
        try (Socket first = new Socket("127.0.0.1", server.root().getPort());
                Socket second = new Socket("127.0.0.1", server.root().getPort())) {
            for (Socket socket : new Socket[] {first, second}) {
                String head = "POST /m/slow HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN
                        + "\r\nContent-Length: 1000\r\n\r\nx";
                socket.getOutputStream().write(head.getBytes(StandardCharsets.ISO_8859_1));
                socket.getOutputStream().flush();
            }
            Await.until("two uploads", () -> store.uploads().length() >= 2);
            HttpResponse<byte[]> answer = send(post("m/bench"), ply(4));
            assertThat(answer.statusCode()).isEqualTo(429);
            assertThat(answer.headers().firstValue("Retry-After").orElse("")).matches("[1-9]\\d*");
        }
        Await.until("an empty queue", () -> store.uploads().length() == 0);
        assertThat(await(send(post("m/bench"), ply(4))).get("state").asText()).isEqualTo("ready");
    }

    @Test
    void shouldEndWhatTakesTooLong() throws Exception {
        settings = settings.withEncodeMillis(1);
        open();
        JsonNode status = await(send(post("m/bench"), ply(30)));
        assertThat(status.get("error").asText()).contains("took longer");
        assertNothingIsLeft();
        assertThat(models.resolve("uploads/bench.jsm")).doesNotExist();
    }
}
