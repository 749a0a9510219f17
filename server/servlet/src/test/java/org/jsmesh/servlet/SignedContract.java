package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What every container has to answer where addresses are signed. */
abstract class SignedContract extends ContractServer {
    @TempDir
    private Path secrets;

    private SignKeys keys;

    abstract TestServer start(ModelStore store, ServletSettings settings) throws Exception;

    @Override
    final TestServer start(ModelStore store) throws Exception {
        Files.write(folder.resolve("horse.jsm"), ARCHIVE);
        Path file = Files.writeString(secrets.resolve("keys"), "0123456789abcdef0123456789abcdef\n");
        keys = SignKeys.read(file);
        return start(store, ServletSettings.defaults().withSignKeys(keys));
    }

    private String query(String id, int seconds) {
        return keys.query(id, Instant.now().plusSeconds(seconds));
    }

    private void assertRefused(String path, String words) throws Exception {
        HttpResponse<byte[]> answer = get(path);
        assertThat(answer.statusCode()).as(path).isEqualTo(403);
        assertThat(assertError(answer).get("error").asText()).contains(words);
        assertThat(answer.headers().firstValue("ETag")).isEmpty();
    }

    @Test
    void shouldOpenNothingWithoutASignature() throws Exception {
        for (String path : new String[] {
            "m/index.json",
            "m/",
            "m/bunny",
            "m/bunny/",
            "m/bunny/manifest.json",
            "m/bunny/annotations.json",
            "m/bunny/status",
            archiveUrl(),
            "m/bunny/" + sha256 + "/first.jsm",
            "m/bunny/" + sha256 + "/poster.jpg",
            "m/bunny/" + sha256 + "/batches/0-0",
            "m/bunny/" + sha256 + "/patches?from=0&bytesPerSecond=1&waitMillis=1",
            "m/nobody/manifest.json"
        }) {
            assertRefused(path, "not signed");
            String more = path.contains("?") ? "&" : "?";
            assertRefused(path + more + query("horse", 100), "not that of the server");
            assertRefused(path + more + query("", -1), "is over");
        }
        assertRefused("m/bunny/manifest.json?" + query("bunny", -1), "is over");
        assertRefused("m/index.json?" + query("bunny", 100), "not that of the server");
    }

    @Test
    void shouldLeadFromOneSignedAddressToAllOfAModel() throws Exception {
        String query = query("bunny", 1000);
        HttpResponse<byte[]> answer = get("m/bunny/manifest.json?" + query);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(header(answer, "Cache-Control")).isEqualTo("private, max-age=10");
        JsonNode manifest = JSON.readTree(answer.body());
        assertThat(manifest.get("archiveUrl").asText()).isEqualTo(sha256 + ".jsm?" + query);
        HttpResponse<byte[]> part = get(
                "m/bunny/" + manifest.get("archiveUrl").asText(), "Range", "bytes=5-9", "If-Range", '"' + sha256 + '"');
        assertThat(part.statusCode()).isEqualTo(206);
        assertThat(part.body()).hasSize(5);
        assertThat(header(part, "Cache-Control")).startsWith("private, max-age=31536000, immutable");
        assertThat(header(part, "ETag")).isEqualTo('"' + sha256 + '"');
        assertThat(get("m/bunny/" + manifest.get("firstUrl").asText()).statusCode())
                .isEqualTo(200);
        String patches = "m/bunny/" + sha256 + "/patches?" + query + "&from=0&bytesPerSecond=1000&waitMillis=1";
        assertThat(get(patches).statusCode()).isEqualTo(200);
        HttpResponse<byte[]> page = get("m/bunny/?" + query);
        assertThat(page.statusCode()).isEqualTo(200);
        String html = new String(page.body(), StandardCharsets.UTF_8);
        assertThat(html).contains("m/bunny/manifest.json?" + query, sha256 + ".jsm?" + query);
        HttpResponse<byte[]> folder = get("m/bunny?" + query);
        assertThat(folder.statusCode()).isEqualTo(308);
        assertThat(header(folder, "Location")).isEqualTo("bunny/?" + query);
    }

    @Test
    void shouldListModelsForWhoMayHaveAll() throws Exception {
        String query = query(SignKeys.ALL, 1000);
        HttpResponse<byte[]> answer = get("m/index.json?" + query);
        assertThat(answer.statusCode()).isEqualTo(200);
        for (JsonNode model : JSON.readTree(answer.body()).get("models")) {
            String manifestUrl = model.get("manifestUrl").asText();
            assertThat(manifestUrl).endsWith("/manifest.json?" + query);
            assertThat(get("m/" + manifestUrl).statusCode()).isEqualTo(200);
        }
    }
}
