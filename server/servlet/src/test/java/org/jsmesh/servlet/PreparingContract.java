package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.net.Socket;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.jsmesh.store.CountingEncoder;
import org.junit.jupiter.api.Test;

/** How every container has to answer while models are encoded: at once or nearly so, and with what is known. */
abstract class PreparingContract extends ContractServer {
    private CompletableFuture<HttpResponse<byte[]>> ask(String path) {
        HttpRequest request = request(path).build();
        return client.sendAsync(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    @Test
    void shouldEncodeOnceForAllWhoAskAtTheSameTime() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        store.list(); // looks at once
        encoder.hold();
        List<CompletableFuture<HttpResponse<byte[]>>> answers = new ArrayList<>();
        for (int i = 0; i < 300; i++) answers.add(ask("m/horse/manifest.json"));
        encoder.awaitRunning(1);
        assertThat(get(archiveUrl()).statusCode())
                .as("others are served meanwhile")
                .isEqualTo(200);
        for (CompletableFuture<HttpResponse<byte[]>> answer : answers)
            assertThat(answer.get(30, TimeUnit.SECONDS).statusCode())
                    .as("nobody is held")
                    .isEqualTo(202);
        encoder.release();
        HttpResponse<byte[]> manifest = whenReady("m/horse/manifest.json");
        assertThat(encoder.begun()).isEqualTo(1);
        String url = JSON.readTree(manifest.body()).get("archiveUrl").asText();
        assertThat(get("m/horse/" + url).body()).isEqualTo(CountingEncoder.archiveOf("horse"));
    }

    @Test
    void shouldTellHowFarTheEncodingIs() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        store.list(); // looks at once
        encoder.hold();
        HttpResponse<byte[]> answer = ask("m/horse/manifest.json").get(30, TimeUnit.SECONDS);
        assertThat(answer.statusCode()).isEqualTo(202);
        assertThat(header(answer, "Retry-After")).matches("[1-9]\\d*");
        assertThat(header(answer, "Cache-Control")).isEqualTo("no-store");
        assertThat(answer.headers().firstValue("ETag")).isEmpty();
        JsonNode state = JSON.readTree(answer.body());
        assertThat(state.get("id").asText()).isEqualTo("horse");
        assertThat(state.get("state").asText()).isEqualTo("preparing");
        assertThat(state.get("stage").asText()).isNotBlank();
        assertThat(state.get("fraction").asDouble()).isBetween(0.0, 1.0);
    }

    /** Whoever asks for bytes must not take anything else for them. */
    @Test
    void shouldRefuseBytesThatAreNotThereYet() throws Exception {
        Files.writeString(folder.resolve("horse.ply"), "horse");
        store.list(); // looks at once
        encoder.hold();
        HttpResponse<byte[]> answer = ask("m/horse/" + sha256 + ".jsm").get(30, TimeUnit.SECONDS);
        assertThat(answer.statusCode()).isEqualTo(503);
        assertThat(header(answer, "Retry-After")).matches("[1-9]\\d*");
        assertError(answer);
    }

    @Test
    void shouldBeFreeForOthersWhenClientsHangUp() throws Exception {
        Files.writeString(folder.resolve("slow.ply"), "slow");
        store.list(); // looks at once
        encoder.hold();
        for (int i = 0; i < 1500; i++) {
            try (Socket socket =
                    new Socket(server.root().getHost(), server.root().getPort())) {
                String request = "GET /m/slow/manifest.json HTTP/1.1\r\nHost: localhost\r\n\r\n";
                socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
            }
        }
        assertThat(get(archiveUrl()).body()).isEqualTo(ARCHIVE);
        assertThat(ask("m/slow/manifest.json").get(30, TimeUnit.SECONDS).statusCode())
                .isEqualTo(202);
    }

    @Test
    void shouldSayThatItIsStoppingNotThatTheModelIsBad() throws Exception {
        Files.writeString(folder.resolve("slow.ply"), "slow");
        store.list(); // looks at once
        encoder.hold();
        CompletableFuture<HttpResponse<byte[]>> waiting = ask("m/slow/manifest.json");
        encoder.awaitRunning(1);
        store.close();
        HttpResponse<byte[]> answer = waiting.get(30, TimeUnit.SECONDS);
        assertThat(answer.statusCode()).isEqualTo(503);
        assertThat(header(answer, "Retry-After")).matches("[1-9]\\d*");
        assertThat(assertError(answer).get("error").asText()).isEqualTo("the server is stopping");
    }

    @Test
    void shouldAnswerThatARemovedModelIsGone() throws Exception {
        assertThat(get(archiveUrl()).statusCode()).isEqualTo(200);
        Files.delete(folder.resolve("Bunny.jsm"));
        HttpResponse<byte[]> answer = get("m/bunny/manifest.json");
        assertThat(answer.statusCode()).isEqualTo(404);
        assertError(answer);
    }
}
