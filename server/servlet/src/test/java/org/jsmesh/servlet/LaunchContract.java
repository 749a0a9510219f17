package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.Arrays;
import javax.xml.parsers.DocumentBuilderFactory;
import org.jsmesh.secret.SignKeys;
import org.jsmesh.servlet.http.Digests;
import org.jsmesh.servlet.testing.SignedJars;
import org.jsmesh.servlet.testing.TestServer;
import org.jsmesh.store.ModelStore;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** What every container has to answer to those who start the desktop viewer from a browser. */
abstract class LaunchContract extends ContractServer {
    @TempDir
    private static Path jars;

    private Path jar;
    private ServletSettings settings;

    abstract TestServer start(ModelStore store, ServletSettings settings) throws Exception;

    @Override
    final TestServer start(ModelStore store) throws Exception {
        Files.write(folder.resolve("Tea <\"&'\u0007> pot.jsm"), ARCHIVE);
        Files.write(folder.resolve("椅子.jsm"), ARCHIVE);
        store.list(); // looks at once
        jar = jars.resolve("jsm-viewer.jar");
        if (!Files.exists(jar)) SignedJars.viewer(jar, 200_000);
        settings = ServletSettings.defaults().withViewer(ViewerJar.open(jar));
        return start(store, settings);
    }

    private void restart(ServletSettings changed) throws Exception {
        server.stop();
        server = start(store, changed);
    }

    /** The root of the text, which must be well-formed. */
    private Element launch(String path, String... headers) throws Exception {
        HttpResponse<byte[]> answer = get(path, headers);
        assertThat(answer.statusCode()).as(path).isEqualTo(200);
        assertThat(header(answer, "Content-Type")).isEqualTo("application/x-java-jnlp-file");
        assertThat(header(answer, "Cache-Control")).isEqualTo("private, no-cache");
        assertThat(answer.headers().firstValue("Content-Encoding")).isEmpty();
        assertThat(get(path, "If-None-Match", header(answer, "ETag")).statusCode())
                .isEqualTo(304);
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(answer.body()))
                .getDocumentElement();
    }

    private static Element part(Element root, String name) {
        assertThat(root.getElementsByTagName(name).getLength()).as(name).isEqualTo(1);
        return (Element) root.getElementsByTagName(name).item(0);
    }

    /** What the viewer is to open. Nothing behind the first argument is an option. */
    private static String address(Element root) {
        NodeList arguments = root.getElementsByTagName("argument");
        assertThat(arguments.getLength()).isEqualTo(2);
        assertThat(arguments.item(0).getTextContent()).isEqualTo("--");
        return arguments.item(1).getTextContent();
    }

    @Test
    void shouldSayHowTheViewerIsStartedWithAModel() throws Exception {
        Element root = launch("m/bunny/viewer.jnlp");
        assertThat(root.getTagName()).isEqualTo("jnlp");
        assertThat(root.getAttribute("codebase"))
                .isEqualTo(server.root().resolve("m/").toString());
        part(root, "all-permissions");
        assertThat(part(root, "title").getTextContent()).isEqualTo("Bunny · jSM viewer");
        assertThat(part(root, "application-desc").getAttribute("main-class")).isEqualTo("org.example.Main");
        assertThat(address(root))
                .isEqualTo(server.root().resolve("m/bunny/manifest.json").toString());
        String href = "m/" + part(root, "jar").getAttribute("href");
        assertThat(href).endsWith("/jsm-viewer.jar");
        assertThat(get(href).body()).isEqualTo(Files.readAllBytes(jar));
        assertThat(part(root, "jar").getAttribute("size")).isEqualTo(Long.toString(Files.size(jar)));
    }

    @Test
    void shouldEscapeWhatAnybodyMayHaveWritten() throws Exception {
        Element root = launch("m/tea-pot/viewer.jnlp");
        assertThat(part(root, "title").getTextContent()).isEqualTo("Tea <\"&' > pot · jSM viewer");
        String chair = store.list().stream()
                .filter(model -> model.entry().name().equals("椅子"))
                .findFirst()
                .orElseThrow()
                .entry()
                .segment();
        assertThat(chair).startsWith("%E6%A4%85");
        HttpResponse<byte[]> answer = get("m/" + chair + "/viewer.jnlp");
        assertThat(header(answer, "Content-Disposition")).isEqualTo("inline; filename*=UTF-8''" + chair + ".jnlp");
        String manifest = address(launch("m/" + chair + "/viewer.jnlp"));
        assertThat(manifest).isEqualTo(server.root() + "m/" + chair + "/manifest.json");
        assertThat(whenReady(manifest.substring(server.root().toString().length()))
                        .statusCode())
                .isEqualTo(200);
    }

    @Test
    void shouldSendTheViewerLikeAnyImmutableFile() throws Exception {
        byte[] bytes = Files.readAllBytes(jar);
        String path = "m/.viewer/" + Digests.sha256(bytes) + "/jsm-viewer.jar";
        HttpResponse<byte[]> answer = get(path);
        assertThat(header(answer, "Content-Type")).isEqualTo("application/java-archive");
        assertThat(header(answer, "Cache-Control")).contains("immutable", "no-transform");
        assertThat(header(answer, "ETag")).isEqualTo('"' + Digests.sha256(bytes) + '"');
        assertThat(header(answer, "Content-Length")).isEqualTo(Integer.toString(bytes.length));
        HttpResponse<byte[]> range = get(path, "Range", "bytes=70000-170000");
        assertThat(range.statusCode()).isEqualTo(206);
        assertThat(range.body()).isEqualTo(Arrays.copyOfRange(bytes, 70_000, 170_001));
        assertThat(get(path, "Range", "bytes=" + bytes.length + "-").statusCode())
                .isEqualTo(416);
        assertThat(get(path, "If-None-Match", header(answer, "ETag")).statusCode())
                .isEqualTo(304);
        HttpRequest head = request(path)
                .method("HEAD", HttpRequest.BodyPublishers.noBody())
                .build();
        assertThat(client.send(head, HttpResponse.BodyHandlers.ofByteArray()).body())
                .isEmpty();
        for (String wrong : new String[] {"m/.viewer/", "m/.viewer/x/jsm-viewer.jar", path + "/", "m/.viewer"})
            assertThat(get(wrong).statusCode()).as(wrong).isEqualTo(404);
    }

    @Test
    void shouldPutTheAddressThatVisitorsHaveBeforeTheOneThatWasAskedFor() throws Exception {
        restart(settings.withPublicUrl("https://example.org/meshes/"));
        Element root = launch("m/bunny/viewer.jnlp");
        assertThat(root.getAttribute("codebase")).isEqualTo("https://example.org/meshes/m/");
        assertThat(address(root)).isEqualTo("https://example.org/meshes/m/bunny/manifest.json");
    }

    @Test
    void shouldHandOnTheSignatureOfTheRequest() throws Exception {
        SignKeys keys = SignKeys.read(Files.writeString(jars.resolve("keys"), "0123456789abcdef0123456789abcdef\n"));
        restart(settings.withSignKeys(keys));
        assertThat(get("m/bunny/viewer.jnlp").statusCode()).isEqualTo(403);
        String query = keys.query("bunny", Instant.now().plusSeconds(1000));
        Element root = launch("m/bunny/viewer.jnlp?" + query);
        assertThat(address(root)).isEqualTo(server.root() + "m/bunny/manifest.json?" + query);
        // The program is for everybody.
        assertThat(get("m/" + part(root, "jar").getAttribute("href")).statusCode())
                .isEqualTo(200);
    }

    @Test
    void shouldFollowAViewerThatIsReplacedOrGoes() throws Exception {
        Path own = Files.copy(jar, folder.resolve("viewer-jar"));
        restart(settings.withViewer(ViewerJar.open(own)));
        String before = part(launch("m/bunny/viewer.jnlp"), "jar").getAttribute("href");
        Path next = SignedJars.viewer(jars.resolve("next.jar"), 300_000);
        Files.move(next, own, StandardCopyOption.REPLACE_EXISTING);
        String after = part(launch("m/bunny/viewer.jnlp"), "jar").getAttribute("href");
        assertThat(after).isNotEqualTo(before);
        assertThat(get("m/" + after).body()).isEqualTo(Files.readAllBytes(own));
        assertThat(get("m/" + before).statusCode()).isEqualTo(404);
        Files.delete(own);
        assertRefused("m/bunny/viewer.jnlp");
        assertRefused("m/" + after);
    }

    @Test
    void shouldSayThatThereIsNoViewer() throws Exception {
        restart(settings.withViewer(null));
        assertRefused("m/bunny/viewer.jnlp");
        assertRefused("m/.viewer/" + "0a".repeat(32) + "/jsm-viewer.jar");
        restart(settings);
        assertThat(get("m/nobody/viewer.jnlp").statusCode()).isEqualTo(404);
    }

    private void assertRefused(String path) throws Exception {
        HttpResponse<byte[]> answer = get(path);
        assertThat(answer.statusCode()).as(path).isEqualTo(404);
        assertThat(assertError(answer).get("error").asText()).contains("no desktop viewer");
        assertThat(new String(answer.body(), StandardCharsets.UTF_8)).doesNotContain(jars.toString());
    }
}
