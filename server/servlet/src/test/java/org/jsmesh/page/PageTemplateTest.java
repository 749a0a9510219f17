package org.jsmesh.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Base64;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class PageTemplateTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final String HTML = """
            <!doctype html>
            <html lang="en">
              <head>
                <meta charset="utf-8">
                <meta name="description" content="Models.">
                <title>jSM</title>
                <meta name="jsm-model-files" content="viewer/v-1.js viewer/d-2.wasm">
                <script type="module" src="viewer/app.js"></script>
              </head>
              <body class="page">
                <main></main>
                <noscript><p>Scripts are off.</p></noscript>
              </body>
            </html>
            """;
    private static final PageTemplate TEMPLATE = new PageTemplate(HTML, Map.of());
    private static final byte[] POSTER = {(byte) 0xff, (byte) 0xd8, 1, 2, 3};
    private static final String SHA = "ab".repeat(32);

    @Test
    void shouldShowThePosterFirst() {
        String page = page("Tea pot");
        String data = Base64.getEncoder().encodeToString(POSTER);
        assertThat(page).containsSubsequence("<body class=\"page\">", "<img class=\"poster\"", data, "<main>");
        assertThat(page)
                .contains("alt=\"Tea pot\" width=\"480\" height=\"360\" src=\"data:image/jpeg;base64," + data + "\"");
    }

    @Test
    void shouldTellThoseWhoShowLinks() {
        String page = page("Tea pot");
        assertThat(page).contains("<title>Tea pot · jSM</title>").doesNotContain("<title>jSM</title>");
        assertThat(page).contains("<meta name=\"description\" content=\"Tea pot, a model of 6,320 faces in 75 kB. ");
        assertThat(page).contains("<meta property=\"og:title\" content=\"Tea pot\">");
        assertThat(page)
                .contains("<meta property=\"og:image\" content=\"https://x.example/a/m/tea-pot/" + SHA
                        + "/poster.jpg\">");
        assertThat(page).contains("<meta property=\"og:url\" content=\"https://x.example/a/m/tea-pot/\">");
        assertThat(page).contains("<meta name=\"twitter:card\" content=\"summary_large_image\">");
    }

    @Test
    void shouldSayWhereItsLinksBegin() {
        assertThat(page("Tea pot"))
                .containsSubsequence("<meta charset=\"utf-8\">", "<base href=\"../../\">", "src=\"viewer");
    }

    @Test
    void shouldHaveTheManifestWithoutTheIndex() throws Exception {
        JsonNode manifest = manifestOf(page("Tea pot"));
        assertThat(manifest.get("name").asText()).isEqualTo("Tea pot");
        assertThat(manifest.get("archiveUrl").asText()).isEqualTo(SHA + ".jsm");
        assertThat(manifest.get("manifestUrl").asText()).isEqualTo("m/tea-pot/manifest.json");
        assertThat(manifest.has("batches")).isFalse();
    }

    @Test
    void shouldAskForTheFirstBytesBehindThePoster() {
        assertThat(page("Tea pot"))
                .containsSubsequence(
                        "id=\"poster\"",
                        "<link rel=\"preload\" as=\"fetch\" crossorigin href=\"m/tea-pot/" + SHA + "/first\">",
                        "<link rel=\"modulepreload\" href=\"viewer/v-1.js\">",
                        "<link rel=\"preload\" as=\"fetch\" crossorigin=\"anonymous\" href=\"viewer/d-2.wasm\">",
                        "<main>");
    }

    @Test
    void shouldHelpThoseWithoutScripts() {
        Matcher off =
                Pattern.compile("<noscript>(.*?)</noscript>", Pattern.DOTALL).matcher(page("Tea pot"));
        assertThat(off.find()).isTrue();
        assertThat(off.group(1))
                .contains("Scripts are off.", "Tea pot", "6,320 faces in 75 kB")
                .contains("href=\"m/tea-pot/" + SHA + ".jsm\"")
                .contains("href=\"m/tea-pot/" + SHA + "/poster.jpg\"");
    }

    @Test
    void shouldTakeNoNameForMarkup() throws Exception {
        String name = "</title></script><script>alert(1)</script>\"'><img onerror=x> $1 \\ & 椅子 <!--";
        String page = page(name);
        assertThat(page)
                .doesNotContain("<script>alert")
                .doesNotContain("<img onerror")
                .doesNotContain("<!--");
        assertThat(page.split("</script>", -1)).hasSize(3);
        assertThat(page).contains("&lt;/title&gt;&lt;/script&gt;", "$1 \\ &amp; 椅子");
        assertThat(manifestOf(page).get("name").asText()).isEqualTo(name);
    }

    @Test
    void shouldShowWhatThereIsOfAModelThatIsNotEncoded() throws Exception {
        String page = TEMPLATE.page("tea-pot", "{\"id\":\"tea-pot\",\"name\":\"Tea pot\"}", null, null);
        assertThat(page).contains("<title>Tea pot · jSM</title>", "not encoded yet");
        assertThat(page).doesNotContain("<img", "og:image", "og:url");
        assertThat(manifestOf(page).get("manifestUrl").asText()).isEqualTo("m/tea-pot/manifest.json");
    }

    @Test
    void shouldRefuseAPageWithoutItsPlaces() {
        assertThatThrownBy(() -> new PageTemplate(HTML.replace("<title>jSM</title>", ""), Map.of()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("title");
        assertThatThrownBy(() -> TEMPLATE.page("a", "[]", null, null)).isInstanceOf(IllegalArgumentException.class);
    }

    private static String page(String name) {
        return TEMPLATE.page("tea-pot", manifest(name), POSTER, "https://x.example/a/");
    }

    private static String manifest(String name) {
        ObjectNode manifest = JSON.createObjectNode().put("id", "tea-pot").put("name", name);
        manifest.put("archiveUrl", SHA + ".jsm")
                .put("posterUrl", SHA + "/poster.jpg")
                .put("firstUrl", SHA + "/first");
        manifest.put("faces", 6320).put("bytes", 75_400).putArray("batches").add(1);
        return manifest.toString();
    }

    private static JsonNode manifestOf(String page) throws Exception {
        Matcher found = Pattern.compile("<script type=\"application/json\" id=\"manifest\">(.*?)</script>")
                .matcher(page);
        assertThat(found.find()).isTrue();
        return JSON.readTree(found.group(1));
    }
}
