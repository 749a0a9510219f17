package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.List;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Test;

/** A server that lets the pages of one other origin in. */
class CrossOriginTest extends ContractServer {
    @Override
    TestServer start(ModelStore store) throws Exception {
        ServletSettings settings = ServletSettings.defaults().withOrigins(List.of("https://a.example"));
        return new JettyServer(TestApplication.of(store, settings));
    }

    @Test
    void shouldLetTheChosenOriginRead() throws Exception {
        HttpResponse<byte[]> answer = get(archiveUrl(), "Origin", "https://a.example");
        assertThat(header(answer, "Access-Control-Allow-Origin")).isEqualTo("https://a.example");
        assertThat(header(answer, "Timing-Allow-Origin")).isEqualTo("https://a.example");
        assertThat(header(answer, "Cross-Origin-Resource-Policy")).isEqualTo("cross-origin");
        assertThat(answer.headers().allValues("Vary")).contains("Origin");
        assertThat(get("/m/").headers().allValues("Vary")).contains("Origin", "Accept");
    }

    @Test
    void shouldNotLetOthersRead() throws Exception {
        for (String origin : List.of("https://b.example", "https://a.example.evil", "null")) {
            HttpResponse<byte[]> answer = get(archiveUrl(), "Origin", origin);
            assertThat(answer.headers().firstValue("Access-Control-Allow-Origin"))
                    .isEmpty();
            assertThat(header(answer, "Cross-Origin-Resource-Policy")).isEqualTo("same-origin");
            HttpRequest preflight = request(archiveUrl(), "Origin", origin)
                    .method("OPTIONS", HttpRequest.BodyPublishers.noBody())
                    .build();
            HttpResponse<byte[]> refused = client.send(preflight, HttpResponse.BodyHandlers.ofByteArray());
            assertThat(refused.headers().firstValue("Access-Control-Allow-Methods"))
                    .isEmpty();
        }
    }

    @Test
    void shouldRefuseWhatIsNoOrigin() {
        assertThatThrownBy(() -> ServletSettings.defaults().withOrigins(List.of("https://a.example/path")))
                .hasMessageContaining("https://a.example/path");
    }
}
