package org.jsmesh.webapp;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.apache.catalina.Context;
import org.apache.catalina.Lifecycle;
import org.apache.catalina.startup.Tomcat;
import org.eclipse.jetty.ee.webapp.WebAppClassLoader;
import org.eclipse.jetty.ee11.webapp.WebAppContext;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The WAR as it was built, in a Tomcat and in a Jetty that lend it none of the project's classes: the same answers, and
 * the bytes of the file.
 */
@Timeout(300)
class WarIT {
    private static final Logger LOG = Logger.getLogger("org.apache");
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    static Path folder;

    @TempDir
    static Path caches;

    @TempDir
    static Path base;

    private static final HttpClient CLIENT = HttpClient.newHttpClient();
    private static final Tomcat TOMCAT = new Tomcat();
    private static final Server JETTY = new Server();
    private static URI jetty;
    private static URI tomcat;

    @BeforeAll
    static void startServers() throws Exception {
        LOG.setLevel(Level.SEVERE);
        Files.writeString(folder.resolve("bumpy.obj"), bumpyGrid(60));
        Files.writeString(folder.resolve("broken.obj"), "v 0 0 nan\n");
        MeshEncoder encoder = new MeshEncoder(EncoderSettings.defaults());
        byte[] archive = encoder.encode(
                        ModelFiles.read(folder.resolve("bumpy.obj")).mesh(), ProgressListener.NONE)
                .bytes();
        Files.write(folder.resolve("kept.jsm"), archive);
        startTomcat(Path.of(System.getProperty("jsm.war")));
        startJetty(Path.of(System.getProperty("jsm.war")));
    }

    private static void startJetty(Path war) throws Exception {
        ServerConnector connector = new ServerConnector(JETTY, 1, 1);
        connector.setHost("127.0.0.1");
        JETTY.addConnector(connector);
        WebAppContext context = new WebAppContext(war.toString(), "/");
        context.setTempDirectory(Files.createDirectories(base.resolve("jetty")).toFile());
        context.setInitParameter("jsm.models", folder.toString());
        context.setInitParameter("jsm.cache", caches.resolve("jetty").toString());
        context.setClassLoader(new WebAppClassLoader(new WithoutProject(WarIT.class.getClassLoader()), context));
        context.setThrowUnavailableOnStartupException(true);
        JETTY.setHandler(context);
        JETTY.start();
        jetty = URI.create("http://127.0.0.1:" + connector.getLocalPort() + "/");
    }

    private static void startTomcat(Path war) throws Exception {
        TOMCAT.setBaseDir(base.toString());
        Files.createDirectories(base.resolve("webapps"));
        TOMCAT.setHostname("127.0.0.1");
        TOMCAT.setPort(0);
        TOMCAT.getConnector().setProperty("address", "127.0.0.1");
        Context context = TOMCAT.addWebapp("", war.toString());
        context.addParameter("jsm.models", folder.toString());
        context.addParameter("jsm.cache", caches.resolve("tomcat").toString());
        Path tokens = Files.writeString(base.resolve("tokens"), "0123456789abcdef\n");
        context.addParameter("jsm.upload.token.file", tokens.toString());
        context.setParentClassLoader(new WithoutProject(WarIT.class.getClassLoader()));
        // Tomcat's defaults name a servlet for JSP, which is not on the class path.
        context.addLifecycleListener(event -> {
            if (event.getType().equals(Lifecycle.CONFIGURE_START_EVENT)) {
                for (String pattern : List.of("*.jsp", "*.jspx")) context.removeServletMapping(pattern);
                context.removeChild(context.findChild("jsp"));
            }
        });
        TOMCAT.start();
        tomcat = URI.create("http://127.0.0.1:" + TOMCAT.getConnector().getLocalPort() + "/");
    }

    @AfterAll
    static void stopServers() throws Exception {
        JETTY.stop();
        TOMCAT.stop();
        TOMCAT.destroy();
    }

    @Test
    void shouldAnswerWhatJettyAnswers() throws Exception {
        awaitEncoded("m/bumpy/manifest.json");
        awaitEncoded("m/broken/manifest.json");
        JsonNode manifest = JSON.readTree(assertSame("m/bumpy/manifest.json", 200));
        assertSame("m/broken/manifest.json", 422);
        assertSame("m/", 200);
        String archive = "m/bumpy/" + manifest.get("archiveUrl").asText();
        String batches = "m/bumpy/" + manifest.get("archiveSha256").asText();
        int last = manifest.get("batches").size() - 1;
        assertThat(last).isGreaterThan(3);
        byte[] whole = assertSame(archive, 200);
        assertThat(whole).hasSize(manifest.get("bytes").asInt());
        assertSame(archive, 206, "Range", "bytes=0-999");
        assertSame(archive, 206, "Range", "bytes=1000-");
        assertSame(archive, 206, "Range", "bytes=-10");
        assertSame(archive, 200, "Range", "bytes=0-1,3-4");
        assertSame(archive, 416, "Range", "bytes=" + whole.length + "-");
        assertSame(
                archive,
                304,
                "If-None-Match",
                '"' + manifest.get("archiveSha256").asText() + '"');
        assertThat(assertSame(batches + "/batches/0-" + last, 200)).isEqualTo(whole);
        assertSame(batches + "/batches/1-2", 200);
        assertSame(batches + "/batches/0-" + (last + 1), 404);
        assertSame(batches + "/patches?from=1&bytesPerSecond=10000&waitMillis=500", 200);
        assertSame(batches + "/patches?from=" + (last + 1) + "&bytesPerSecond=1&waitMillis=1", 204);
        assertSame(batches + "/patches", 400);
        assertSame("m/nobody/manifest.json", 404);
    }

    /** Both encode a model first, each in its time. */
    private static void awaitEncoded(String path) throws Exception {
        for (URI root : List.of(tomcat, jetty))
            Await.until("an answer of " + root, () -> get(root, path).statusCode() != 202);
    }

    @Test
    void shouldSendTheBytesOfTheFile() throws Exception {
        JsonNode manifest = JSON.readTree(assertSame("m/kept/manifest.json", 200));
        byte[] file = Files.readAllBytes(folder.resolve("kept.jsm"));
        assertThat(assertSame("m/kept/" + manifest.get("archiveUrl").asText(), 200))
                .isEqualTo(file);
    }

    @Test
    void shouldEncodeWhatIsSentInAProcessOfItsOwn() throws Exception {
        HttpRequest send = HttpRequest.newBuilder(tomcat.resolve("m/sent?name=sent.obj"))
                .header("Authorization", "Bearer 0123456789abcdef")
                .POST(HttpRequest.BodyPublishers.ofString(bumpyGrid(20)))
                .build();
        assertThat(CLIENT.send(send, HttpResponse.BodyHandlers.discarding()).statusCode())
                .isEqualTo(202);
        Await.until("the model to be encoded", () -> !status(tomcat).matches("(?s).*(queued|encoding).*"));
        assertThat(status(tomcat)).contains("ready");
        assertThat(folder.resolve("uploads/sent.jsm")).exists();
    }

    private static String status(URI root) throws Exception {
        return new String(get(root, "m/sent/status").body(), StandardCharsets.UTF_8);
    }

    @Test
    void shouldCarryThePage() throws Exception {
        shouldCarryThePage(tomcat);
        shouldCarryThePage(jetty);
    }

    private static void shouldCarryThePage(URI root) throws Exception {
        HttpResponse<byte[]> page = get(root, "");
        assertThat(page.statusCode()).isEqualTo(200);
        assertThat(page.headers().firstValue("Content-Type").orElseThrow().replace(" ", ""))
                .isEqualToIgnoringCase("text/html;charset=utf-8");
        assertThat(get(root, PageNames.script(page.body())).statusCode()).isEqualTo(200);
        assertThat(get(root, PageNames.largest(".wasm")).headers().firstValue("Content-Type"))
                .contains("application/wasm");
        assertThat(get(root, "WEB-INF/web.xml").statusCode()).isEqualTo(404);
    }

    private static byte[] assertSame(String path, int status, String... headers) throws Exception {
        HttpResponse<byte[]> one = get(tomcat, path, headers);
        HttpResponse<byte[]> other = get(jetty, path, headers);
        assertThat(describe(one)).as(path).isEqualTo(describe(other)).startsWith("status: " + status);
        assertThat(one.body()).as(path).isEqualTo(other.body());
        return one.body();
    }

    private static HttpResponse<byte[]> get(URI root, String path, String... headers) throws Exception {
        HttpRequest.Builder request = HttpRequest.newBuilder(root.resolve(path));
        if (headers.length > 0) request.headers(headers);
        return CLIENT.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    private static String describe(HttpResponse<byte[]> answer) {
        List<String> lines = new ArrayList<>();
        lines.add("status: " + answer.statusCode());
        for (String name : List.of(
                "Accept-Ranges",
                "Access-Control-Allow-Origin",
                "Cache-Control",
                "Content-Encoding",
                "Content-Location",
                "Content-Range",
                "Content-Security-Policy",
                "Content-Type",
                "Cross-Origin-Opener-Policy",
                "Cross-Origin-Resource-Policy",
                "ETag",
                "Permissions-Policy",
                "Referrer-Policy",
                "Timing-Allow-Origin",
                "Vary",
                "X-Content-Type-Options")) {
            lines.add(name + ": " + answer.headers().allValues(name));
        }
        return String.join("\n", lines);
    }

    /** A height field of 2n² triangles as OBJ. */
    private static String bumpyGrid(int n) {
        StringBuilder obj = new StringBuilder();
        for (int y = 0; y <= n; y++) {
            for (int x = 0; x <= n; x++) {
                obj.append("v ")
                        .append(x)
                        .append(' ')
                        .append(y)
                        .append(' ')
                        .append((x * 7 + y * 13) % 10 / 10.0)
                        .append('\n');
            }
        }
        for (int y = 0; y < n; y++) {
            for (int x = 0; x < n; x++) {
                int a = y * (n + 1) + x + 1;
                int b = a + n + 1;
                obj.append("f ")
                        .append(a)
                        .append(' ')
                        .append(a + 1)
                        .append(' ')
                        .append(b + 1)
                        .append('\n');
                obj.append("f ")
                        .append(a)
                        .append(' ')
                        .append(b + 1)
                        .append(' ')
                        .append(b)
                        .append('\n');
            }
        }
        return obj.toString();
    }

    /** The test's class path without what the WAR must bring along. */
    private static final class WithoutProject extends ClassLoader {
        WithoutProject(ClassLoader parent) {
            super(parent);
        }

        @Override
        protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
            if (name.matches("(org\\.jsmesh|com\\.fasterxml)\\..*")) throw new ClassNotFoundException(name);
            return super.loadClass(name, resolve);
        }
    }
}
