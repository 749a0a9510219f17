package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import org.jsmesh.servlet.http.Digests;
import org.jsmesh.store.TestArchives;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every container has to answer to those who ask for poster, first bytes or page of a model. */
abstract class PosterContract extends ContractServer {
    private static final String BROWSER = "text/html,application/xhtml+xml,*/*;q=0.8";
    private static final byte[] SHOWN = TestArchives.shown(8, 1000, 5000, 2192, 1, 700);
    private static final byte[] POSTER = Arrays.copyOfRange(SHOWN, 8193, 8889);

    private final String shown = Digests.sha256(SHOWN);

    @BeforeEach
    void addModel() throws Exception {
        Files.write(folder.resolve("Tea <pot>.jsm"), SHOWN);
        store.list(); // looks at once
    }

    @Test
    void shouldCutThePosterOutOfTheArchive() throws Exception {
        String path = "m/tea-pot/" + shown + "/poster.jpg";
        HttpResponse<byte[]> answer = get(path);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.body()).isEqualTo(POSTER);
        assertThat(header(answer, "Content-Type")).isEqualTo("image/jpeg");
        assertThat(header(answer, "Content-Length")).isEqualTo("696");
        assertThat(header(answer, "Cache-Control")).contains("immutable");
        HttpResponse<byte[]> again = get(path, "If-None-Match", header(answer, "ETag"));
        assertThat(again.statusCode()).isEqualTo(304);
        HttpResponse<byte[]> head = head(path);
        assertThat(header(head, "Content-Length")).isEqualTo("696");
        assertThat(head.body()).isEmpty();
    }

    @Test
    void shouldSendTheFirstWholeBatches() throws Exception {
        HttpResponse<byte[]> answer = get("m/tea-pot/" + shown + "/first.jsm");
        assertThat(answer.body()).isEqualTo(Arrays.copyOf(SHOWN, 8192));
        assertThat(header(answer, "Content-Type")).isEqualTo("model/vnd.jsm");
        assertThat(header(answer, "Cache-Control")).contains("immutable");
        assertThat(get("m/bunny/" + sha256 + "/first.jsm").body()).isEqualTo(Arrays.copyOf(ARCHIVE, 6500));
        String tag = header(answer, "ETag");
        assertThat(tag).isNotEqualTo(header(get("m/tea-pot/" + shown + "/poster.jpg"), "ETag"));
        assertThat(get("m/tea-pot/" + shown + "/first.jsm", "If-None-Match", tag)
                        .statusCode())
                .isEqualTo(304);
    }

    @Test
    void shouldSayThatThereIsNoPoster() throws Exception {
        HttpResponse<byte[]> answer = get("m/bunny/" + sha256 + "/poster.jpg");
        assertThat(answer.statusCode()).isEqualTo(404);
        assertThat(JSON.readTree(answer.body()).get("error").asText()).contains("no poster");
        assertThat(get("m/tea-pot/" + sha256 + "/poster.jpg").statusCode()).isEqualTo(404);
    }

    @Test
    void shouldNameBothInManifestAndCatalogue() throws Exception {
        JsonNode manifest = JSON.readTree(get("m/tea-pot/manifest.json").body());
        assertThat(manifest.get("firstBytes").asInt()).isEqualTo(8192);
        assertThat(get("m/tea-pot/" + manifest.get("firstUrl").asText()).body()).hasSize(8192);
        assertThat(get("m/tea-pot/" + manifest.get("posterUrl").asText()).body())
                .isEqualTo(POSTER);
        get("m/bunny/manifest.json");
        JsonNode models = JSON.readTree(get("m/").body()).get("models");
        assertThat(models.get(0).has("posterUrl")).isFalse();
        assertThat(get("m/" + models.get(1).get("posterUrl").asText()).body()).isEqualTo(POSTER);
    }

    @Test
    void shouldAnswerWithThePageOfAModel() throws Exception {
        HttpResponse<byte[]> answer = get("m/tea-pot/", "Accept", BROWSER);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(header(answer, "Content-Type")).isEqualToIgnoringCase("text/html;charset=utf-8");
        assertThat(answer.headers().allValues("Vary")).contains("Accept", "Accept-Encoding");
        assertThat(answer.headers().allValues("Content-Security-Policy")).containsExactly("default-src 'self'");
        String root = server.root().toString();
        assertThat(new String(answer.body(), "UTF-8"))
                .contains("<title>Tea &lt;pot&gt; · jSM</title>")
                .contains("content=\"" + root + "m/tea-pot/" + shown + "/poster.jpg\"")
                .contains("data:image/jpeg;base64," + Base64.getEncoder().encodeToString(POSTER));
        assertThat(get("m/tea-pot/", "Accept", "*/*").body()).isEqualTo(answer.body());
        HttpResponse<byte[]> again = get("m/tea-pot/", "If-None-Match", header(answer, "ETag"));
        assertThat(again.statusCode()).isEqualTo(304);
        assertThat(header(head("m/tea-pot/"), "Content-Length")).isEqualTo(Integer.toString(answer.body().length));
    }

    @Test
    void shouldLeadToThePageOfAModel() throws Exception {
        HttpResponse<byte[]> answer = get("m/tea-pot", "Accept", BROWSER);
        assertThat(answer.statusCode()).isEqualTo(308);
        assertThat(location("m/tea-pot", answer)).isEqualTo(server.root().resolve("m/tea-pot/"));
        for (String path : List.of("m/tea-pot/", "m/tea-pot"))
            assertThat(get(path, "Accept", "application/json").statusCode()).isEqualTo(404);
        assertThat(get("m/nothing/", "Accept", BROWSER).statusCode()).isEqualTo(404);
    }

    @Test
    void shouldAnswerWithThePageOfAModelThatIsNotEncoded() throws Exception {
        encoder.hold();
        Files.writeString(folder.resolve("horse.ply"), "horse");
        store.list(); // looks at once
        HttpResponse<byte[]> answer = get("m/horse/", "Accept", BROWSER);
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(new String(answer.body(), "UTF-8"))
                .contains("<title>horse · jSM</title>", "not encoded yet")
                .doesNotContain("<img class=\"poster\"");
        encoder.release();
    }

    private HttpResponse<byte[]> head(String path) throws Exception {
        HttpRequest request = request(path)
                .method("HEAD", HttpRequest.BodyPublishers.noBody())
                .build();
        return client.send(request, HttpResponse.BodyHandlers.ofByteArray());
    }
}
