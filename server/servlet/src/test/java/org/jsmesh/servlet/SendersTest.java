package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.List;
import org.jsmesh.servlet.testing.JettyServer;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A server that takes models from the pages of one other origin. */
class SendersTest extends UploadFixture {
    private static final String FRIEND = "https://a.example";

    @Override
    TestServer start(ModelStore withUploads) throws Exception {
        ServletSettings settings =
                ServletSettings.defaults().withOrigins(List.of()).withSenders(List.of(FRIEND));
        return new JettyServer(TestApplication.of(withUploads, settings));
    }

    private HttpResponse<byte[]> preflight(String path, String origin) throws Exception {
        HttpRequest request = HttpRequest.newBuilder(server.root().resolve(path))
                .header("Origin", origin)
                .method("OPTIONS", HttpRequest.BodyPublishers.noBody())
                .build();
        return client.send(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    @ParameterizedTest
    @ValueSource(strings = {"m/bench, POST, DELETE", "m/.uploads/, POST, PATCH, HEAD, DELETE"})
    void shouldTakeModelsFromPagesOfTheChosenOriginAlone(String pathAndMethods) throws Exception {
        open();
        String[] words = pathAndMethods.split(", ");
        HttpResponse<byte[]> friend = preflight(words[0], FRIEND);
        assertThat(friend.headers().firstValue("Access-Control-Allow-Origin")).contains(FRIEND);
        String methods =
                friend.headers().firstValue("Access-Control-Allow-Methods").orElse("");
        for (int i = 1; i < words.length; i++) assertThat(methods).contains(words[i]);
        assertThat(friend.headers().firstValue("Access-Control-Allow-Headers").orElse(""))
                .contains("Authorization", "Tus-Resumable", "Upload-Offset", "Repr-Digest");
        assertThat(friend.headers().firstValue("Access-Control-Expose-Headers").orElse(""))
                .contains("Location", "Upload-Offset", "Link");
        for (String origin : List.of("https://b.example", "https://a.example.evil", "null")) {
            HttpResponse<byte[]> other = preflight(words[0], origin);
            assertThat(other.headers().firstValue("Access-Control-Allow-Origin"))
                    .isEmpty();
            assertThat(other.headers().firstValue("Access-Control-Allow-Methods"))
                    .isEmpty();
        }
    }
}
