package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.Base64;
import org.jsmesh.test.Await;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What senders may keep and remove, and what the server promises about the bytes that they send. */
abstract class UploadRulesContract extends UploadFixture {
    private static String sha256(String text) throws Exception {
        byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
        return "sha-256=:" + Base64.getEncoder().encodeToString(digest) + ":";
    }

    private HttpResponse<byte[]> delete(String id, String token) throws Exception {
        return client.send(
                post("m/" + id)
                        .setHeader("Authorization", "Bearer " + token)
                        .DELETE()
                        .build(),
                HttpResponse.BodyHandlers.ofByteArray());
    }

    private int status(String path) throws Exception {
        return get(server.root().resolve(path)).statusCode();
    }

    @ParameterizedTest
    @ValueSource(strings = {"Repr-Digest", "Content-Digest"})
    void shouldTakeOnlyTheBytesOfTheDigest(String field) throws Exception {
        open();
        assertRefused(send(post("m/bench").header(field, sha256("others")), ply(4)), 400, "digest");
        assertRefused(send(post("m/bench").header(field, "sha-256=nonsense"), ply(4)), 400, field);
        assertThat(status("m/bench/status")).isEqualTo(404);
        assertThat(await(send(post("m/bench").header(field, "unixsum=:AAA=:, " + sha256(ply(4))), ply(4)))
                        .get("state")
                        .asText())
                .isEqualTo("ready");
    }

    @Test
    void shouldDeleteWhatWasSentAlone() throws Exception {
        open();
        await(send(post("m/bench"), ply(4)));
        assertThat(status("m/bench/manifest.json")).isEqualTo(200);
        assertRefused(delete("bench", TOKEN + "0"), 401, "token");
        assertRefused(delete("bench", CHAIRS), 403, "bench");
        assertRefused(delete("stool", TOKEN), 409, "stool");
        assertThat(status("m/bench/manifest.json")).isEqualTo(200);
        assertThat(delete("bench", TOKEN).statusCode()).isEqualTo(204);
        assertThat(status("m/bench/manifest.json")).isEqualTo(404);
        assertThat(status("m/bench/status")).isEqualTo(404);
        assertThat(models.resolve("uploads/bench.jsm")).doesNotExist();
        assertThat(new String(get(server.root().resolve("m/index.json")).body(), StandardCharsets.UTF_8))
                .contains("stool")
                .doesNotContain("bench");
        assertRefused(delete("bench", TOKEN), 404, "sent");
        assertRefused(delete("a--b", TOKEN), 404, "sent");
        assertThat(await(send(post("m/bench"), ply(5))).get("state").asText()).isEqualTo("ready");
    }

    @Test
    void shouldKeepNoMoreThanItKeepsForAToken() throws Exception {
        Path tokens = Files.writeString(folder.resolve("tokens"), TOKEN + " models=2\n" + CHAIRS + " quota=1K\n");
        settings = UploadSettings.of(UploadTokens.read(tokens)).withHeapMegabytes(48);
        open();
        await(send(post("m/a"), ply(4)));
        await(send(post("m/b"), ply(4)));
        assertRefused(send(post("m/c"), ply(4)), 413, "2 models");
        // What is replaced, or another's, does not count.
        await(send(post("m/b"), ply(5)));
        HttpRequest.Builder other = post("m/d").setHeader("Authorization", "Bearer " + CHAIRS);
        assertThat(await(send(other, ply(40))).get("error").asText()).contains("1024 bytes");
        assertThat(delete("a", TOKEN).statusCode()).isEqualTo(204);
        server.stop();
        store.close();
        open();
        assertThat(await(send(post("m/c"), ply(4))).get("state").asText()).isEqualTo("ready");
        assertRefused(send(post("m/e"), ply(4)), 413, "2 models");
    }

    @Test
    void shouldKnowNewTokensWithoutARestart() throws Exception {
        open();
        String fresh = "f".repeat(32);
        HttpRequest.Builder request = post("m/bench").setHeader("Authorization", "Bearer " + fresh);
        assertRefused(send(request, ply(4)), 401, "token");
        Files.writeString(folder.resolve("tokens"), fresh + "\n");
        Await.until("the new token to be known", () -> send(request, ply(4)).statusCode() == 202);
        assertThat(send(post("m/table"), ply(4)).statusCode()).isEqualTo(401);
        Await.until("the end", () -> store.uploads().length() == 0);
    }
}
