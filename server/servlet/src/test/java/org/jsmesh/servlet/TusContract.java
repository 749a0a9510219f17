package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import io.tus.java.client.TusClient;
import io.tus.java.client.TusURLMemoryStore;
import io.tus.java.client.TusUpload;
import io.tus.java.client.TusUploader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Base64;
import java.util.Map;
import java.util.stream.Stream;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What every container has to do with models that come in parts, by the tus protocol. */
abstract class TusContract extends UploadFixture {
    private static final String PART = "application/offset+octet-stream";

    private static String base64(String text) {
        return Base64.getEncoder().encodeToString(text.getBytes(StandardCharsets.UTF_8));
    }

    private HttpRequest.Builder tus(URI address) {
        return HttpRequest.newBuilder(address)
                .header("Authorization", "Bearer " + TOKEN)
                .header("Tus-Resumable", "1.0.0");
    }

    private HttpRequest.Builder creation(String id, long length) {
        return tus(server.root().resolve("m/.uploads/"))
                .header("Upload-Length", Long.toString(length))
                .header("Upload-Metadata", "id " + base64(id) + ",filename " + base64("x.ply") + ",empty");
    }

    private HttpResponse<byte[]> answer(HttpRequest.Builder request, String method, String body) throws Exception {
        return client.send(
                request.method(method, HttpRequest.BodyPublishers.ofString(body))
                        .build(),
                HttpResponse.BodyHandlers.ofByteArray());
    }

    private URI create(String id, long length) throws Exception {
        HttpResponse<byte[]> answer = answer(creation(id, length), "POST", "");
        assertThat(answer.statusCode())
                .as(new String(answer.body(), StandardCharsets.UTF_8))
                .isEqualTo(201);
        assertThat(header(answer, "Upload-Offset")).isEqualTo("0");
        assertThat(header(answer, "Upload-Expires")).endsWith(" GMT");
        return answer.uri().resolve(header(answer, "Location"));
    }

    private HttpResponse<byte[]> patch(URI upload, long offset, String part) throws Exception {
        return answer(tus(upload).header("Upload-Offset", "" + offset).header("Content-Type", PART), "PATCH", part);
    }

    private HttpResponse<byte[]> head(URI upload) throws Exception {
        return answer(tus(upload), "HEAD", "");
    }

    private static String header(HttpResponse<byte[]> answer, String name) {
        return answer.headers().firstValue(name).orElse("none");
    }

    private JsonNode awaitStatus(HttpResponse<byte[]> last) throws Exception {
        URI status = last.uri().resolve(header(last, "Link").replaceFirst("<(.*)>; rel=\"status\"", "$1"));
        Await.until(
                "the end",
                () -> JSON.readTree(get(status).body()).path("state").asText().matches("ready|failed"));
        return JSON.readTree(get(status).body());
    }

    @Test
    void shouldSayWhatItCan() throws Exception {
        open();
        HttpRequest request = HttpRequest.newBuilder(server.root().resolve("m/.uploads/"))
                .method("OPTIONS", HttpRequest.BodyPublishers.noBody())
                .build();
        HttpResponse<byte[]> answer = client.send(request, HttpResponse.BodyHandlers.ofByteArray());
        assertThat(answer.statusCode()).isEqualTo(204);
        assertThat(header(answer, "Tus-Version")).isEqualTo("1.0.0");
        assertThat(header(answer, "Tus-Extension").split(","))
                .contains("creation", "creation-with-upload", "expiration", "checksum", "termination");
        assertThat(header(answer, "Tus-Max-Size")).isEqualTo("" + MOST_BYTES);
        assertThat(header(answer, "Tus-Checksum-Algorithm").split(",")).contains("sha1", "sha256");
    }

    @Test
    void shouldTakeAModelInPartsAcrossARestart() throws Exception {
        open();
        String text = ply(30);
        URI upload = create("bench", text.length());
        assertThat(header(patch(upload, 0, text.substring(0, 1000)), "Upload-Offset"))
                .isEqualTo("1000");
        assertThat(patch(upload, 0, text.substring(0, 1000)).statusCode()).isEqualTo(409);
        server.stop();
        store.close();
        // What a server leaves that is killed before it has noted what it wrote.
        try (Stream<Path> parts = Files.walk(models.resolve("uploads/.spool"))) {
            Path part = parts.filter(file -> file.endsWith("part")).findFirst().orElseThrow();
            Files.writeString(part, text.substring(0, 1000) + "half a block");
        }
        open();
        upload = server.root().resolve(upload.getPath());
        HttpResponse<byte[]> known = head(upload);
        assertThat(known.statusCode()).isEqualTo(200);
        assertThat(header(known, "Upload-Offset")).isEqualTo("1000");
        assertThat(header(known, "Upload-Length")).isEqualTo("" + text.length());
        assertThat(header(known, "Upload-Metadata")).startsWith("id " + base64("bench"));
        assertThat(header(known, "Cache-Control")).isEqualTo("no-store");
        HttpResponse<byte[]> last = patch(upload, 1000, text.substring(1000));
        assertThat(last.statusCode()).isEqualTo(204);
        assertThat(awaitStatus(last).get("state").asText()).isEqualTo("ready");
        JsonNode manifest = JSON.readTree(
                get(server.root().resolve("m/bench/manifest.json")).body());
        assertThat(manifest.get("faces").asInt()).isEqualTo(2 * 29 * 29);
        // Who has not heard of the end asks again.
        assertThat(header(head(upload), "Upload-Offset")).isEqualTo("" + text.length());
        assertNothingIsLeft();
    }

    @Test
    void shouldKeepWhatCameBeforeAConnectionBroke() throws Exception {
        open();
        String text = ply(30);
        URI upload = create("bench", text.length());
        Socket[] socket = {begin(upload, text)};
        try {
            // One part at a time. What asks begins elsewhere, so that it is refused (409) where it comes before the
            // part; the part is refused where it comes at the same time, and begun again.
            Await.until("the part to be received", () -> {
                if (socket[0].getInputStream().available() > 0) {
                    socket[0].close();
                    socket[0] = begin(upload, text);
                }
                return patch(upload, 1, "x").statusCode() == 423;
            });
        } finally {
            socket[0].close();
        }
        Await.until(
                "what came to be kept",
                () -> header(head(upload), "Upload-Offset").equals("5000"));
        assertThat(awaitStatus(patch(upload, 5000, text.substring(5000)))
                        .get("state")
                        .asText())
                .isEqualTo("ready");
    }

    /** Sends the beginning of a part. */
    private Socket begin(URI upload, String text) throws IOException {
        Socket socket = new Socket("127.0.0.1", server.root().getPort());
        String head = "PATCH " + upload.getPath() + " HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer " + TOKEN
                + "\r\nTus-Resumable: 1.0.0\r\nUpload-Offset: 0\r\nContent-Type: " + PART + "\r\nContent-Length: "
                + text.length() + "\r\n\r\n";
        socket.getOutputStream().write((head + text.substring(0, 5000)).getBytes(StandardCharsets.ISO_8859_1));
        socket.getOutputStream().flush();
        return socket;
    }

    @ParameterizedTest
    @CsvSource({"sha1, SHA-1", "sha256, SHA-256"})
    void shouldKeepNoPartThatIsNotWhatItsChecksumSays(String name, String algorithm) throws Exception {
        open();
        String text = ply(4);
        URI upload = create("bench", text.length());
        byte[] digest = MessageDigest.getInstance(algorithm).digest(text.getBytes(StandardCharsets.UTF_8));
        String good = name + " " + Base64.getEncoder().encodeToString(digest);
        HttpRequest.Builder part = tus(upload)
                .header("Upload-Offset", "0")
                .header("Content-Type", PART)
                .header("Upload-Checksum", good);
        assertThat(answer(part, "PATCH", text.replace('0', '1')).statusCode()).isEqualTo(460);
        assertThat(header(head(upload), "Upload-Offset")).isEqualTo("0");
        HttpRequest.Builder strange = part.copy().setHeader("Upload-Checksum", "md5 AAAA");
        assertThat(answer(strange, "PATCH", text).statusCode()).isEqualTo(400);
        assertThat(awaitStatus(answer(part, "PATCH", text)).get("state").asText())
                .isEqualTo("ready");
    }

    @Test
    void shouldTakeAWholeModelWithItsCreationAndForgetOneThatIsGivenUp() throws Exception {
        open();
        String text = ply(4);
        HttpResponse<byte[]> created =
                answer(creation("bench", text.length()).header("Content-Type", PART), "POST", text);
        assertThat(created.statusCode()).isEqualTo(201);
        assertThat(header(created, "Upload-Offset")).isEqualTo("" + text.length());
        assertThat(awaitStatus(created).get("state").asText()).isEqualTo("ready");
        URI upload = create("table", 1000);
        patch(upload, 0, "ply");
        assertThat(answer(tus(upload), "DELETE", "").statusCode()).isEqualTo(204);
        assertNothingIsLeft();
        assertThat(head(upload).statusCode()).isEqualTo(404);
        assertThat(patch(upload, 3, "ply").statusCode()).isEqualTo(404);
    }

    @Test
    void shouldRemoveWhatNobodyGoesOnWith() throws Exception {
        settings = settings.withUnfinishedMillis(1);
        open();
        URI upload = create("bench", 1000);
        Await.until("the upload to expire", () -> head(upload).statusCode() == 404);
        assertNothingIsLeft();
    }

    @Test
    void shouldAskWhoSendsAndWhat() throws Exception {
        open();
        assertThat(answer(creation("stool", 9), "POST", "").statusCode()).isEqualTo(409);
        assertThat(answer(creation("a--b", 9), "POST", "").statusCode()).isEqualTo(400);
        assertThat(answer(creation("bench", MOST_BYTES + 1), "POST", "").statusCode())
                .isEqualTo(413);
        assertThat(answer(creation("bench", 9).setHeader("Upload-Length", "x"), "POST", "")
                        .statusCode())
                .isEqualTo(400);
        assertThat(answer(creation("bench", 9).setHeader("Upload-Metadata", "id !"), "POST", "")
                        .statusCode())
                .isEqualTo(400);
        String exe = "id " + base64("bench") + ",filename " + base64("x.exe");
        assertThat(answer(creation("bench", 9).setHeader("Upload-Metadata", exe), "POST", "")
                        .statusCode())
                .isEqualTo(415);
        assertThat(answer(creation("bench", 9).setHeader("Tus-Resumable", "0.2.2"), "POST", "")
                        .statusCode())
                .isEqualTo(412);
        HttpRequest.Builder chairs = creation("bench", 9).setHeader("Authorization", "Bearer " + CHAIRS);
        assertThat(answer(chairs, "POST", "").statusCode()).isEqualTo(403);
        assertNothingIsLeft();
        URI upload = create("bench", 9);
        assertThat(answer(tus(upload).setHeader("Authorization", "Bearer " + CHAIRS), "HEAD", "")
                        .statusCode())
                .isEqualTo(403);
        assertThat(patch(upload, 0, "more than was announced").statusCode()).isEqualTo(400);
        assertThat(answer(tus(upload).header("Upload-Offset", "0"), "PATCH", "x")
                        .statusCode())
                .isEqualTo(415);
        // A way for those whose proxies pass no PATCH on.
        HttpRequest.Builder posted = tus(upload)
                .header("X-HTTP-Method-Override", "PATCH")
                .header("Upload-Offset", "0")
                .header("Content-Type", PART);
        assertThat(header(answer(posted, "POST", "ply"), "Upload-Offset")).isEqualTo("3");
        // As many as the queue holds may be unfinished.
        create("bench-2", 9);
        assertThat(answer(creation("bench-3", 9), "POST", "").statusCode()).isEqualTo(429);
    }

    @Test
    void shouldServeAClientOfOthers() throws Exception {
        open();
        byte[] bytes = ply(30).getBytes(StandardCharsets.UTF_8);
        TusClient sender = new TusClient();
        sender.setUploadCreationURL(server.root().resolve("m/.uploads/").toURL());
        sender.setHeaders(Map.of("Authorization", "Bearer " + TOKEN));
        sender.enableResuming(new TusURLMemoryStore());
        sendSome(sender, bytes, 2);
        TusUploader uploader = sender.resumeUpload(upload(bytes));
        assertThat(uploader.getOffset()).isEqualTo(2000);
        uploader.setChunkSize(1000);
        while (uploader.uploadChunk() >= 0) {}
        uploader.finish();
        URI status = server.root().resolve("m/bench/status");
        Await.until(
                "the end",
                () -> JSON.readTree(get(status).body()).path("state").asText().equals("ready"));
    }

    private static TusUpload upload(byte[] bytes) {
        TusUpload upload = new TusUpload();
        upload.setInputStream(new ByteArrayInputStream(bytes));
        upload.setSize(bytes.length);
        upload.setFingerprint("bench");
        upload.setMetadata(Map.of("filename", "Bench.ply"));
        return upload;
    }

    private static void sendSome(TusClient sender, byte[] bytes, int parts)
            throws IOException, io.tus.java.client.ProtocolException {
        TusUploader uploader = sender.resumeOrCreateUpload(upload(bytes));
        uploader.setChunkSize(1000);
        uploader.setRequestPayloadSize(1000);
        for (int i = 0; i < parts; i++) uploader.uploadChunk();
        uploader.finish(false);
    }
}
