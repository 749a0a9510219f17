package org.jsmesh.load;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.app.Bumpy;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A server that serves, encodes and takes uploads for 50 clients, while files are replaced, overwritten, cut and
 * removed, the disk takes no large file, and the process is killed and started again. At its end every download was
 * what its address names, nothing hangs, and nothing is left: no process, no descriptor of a file that is gone, no
 * temporary file.
 */
@Tag("slow")
@Timeout(600)
class ChaosTest {
    private static final int CLIENTS = 50;
    private static final int FILES = 4;
    private static final int CHANGES = 120;
    private static final long PACE_MILLIS = 100;
    private static final String TOKEN = "0123456789abcdef0123456789abcdef";

    /** Largest file that the server and its encoders can write: less than the archive of the large model. */
    private static final int DISK_KILOBYTES = 32;

    private static final int LARGE_RINGS = 150;

    @TempDir
    Path folder;

    private final HttpClient http =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private Path models;
    private ChaosFolder chaos;
    private ServerProcess server;

    @BeforeEach
    void start() throws Exception {
        assumeTrue(ProcessFigures.isPossible(), "the files of a process are read from Linux");
        models = Files.createDirectory(folder.resolve("models"));
        Files.writeString(folder.resolve("tokens"), TOKEN + "\n");
        chaos = new ChaosFolder(models, archives(), tori(24, 27, 30, 33), FILES, 1);
        Bumpy.write(models.resolve("large.ply"), LARGE_RINGS);
        List<String> options =
                List.of("--upload-token-file", folder.resolve("tokens").toString(), "--cache-max-megabytes", "1");
        server = new ServerProcess(folder, models, LoadSettings.brief().withServerOptions(options))
                .withLargestFile(DISK_KILOBYTES);
        server.start();
    }

    @AfterEach
    void stop() {
        if (server != null) server.close();
    }

    private List<byte[]> tori(int... rings) throws IOException {
        List<byte[]> files = new ArrayList<>();
        for (int ring : rings) files.add(Files.readAllBytes(Bumpy.write(folder.resolve("torus.ply"), ring)));
        return files;
    }

    private List<byte[]> archives() throws IOException {
        List<byte[]> archives = new ArrayList<>();
        for (int rings : new int[] {36, 42, 48}) {
            Path model = Bumpy.write(folder.resolve("torus.ply"), rings);
            archives.add(new ModelEncoding(EncoderSettings.defaults())
                    .encode(model, ProgressListener.NONE)
                    .bytes());
        }
        return archives;
    }

    private URI at(String path) {
        return URI.create("http://127.0.0.1:" + server.address().getPort() + "/m/" + path);
    }

    @Tag("long")
    @Test
    void shouldServeTheTruthWhateverHappens() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(CLIENTS);
        List<ChaosClient> clients = new ArrayList<>();
        try {
            long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(2 * CHANGES * PACE_MILLIS);
            List<Future<ChaosClient>> running = new ArrayList<>();
            for (int i = 0; i < CLIENTS; i++)
                running.add(threads.submit(new ChaosClient(http, at(""), chaos.ids(), i, end)));
            for (int i = 0; i < CHANGES; i++) {
                chaos.change();
                if (i % 20 == 5) send("sent-" + i);
                if (i % 30 == 10) get("large/manifest.json");
                if (i == CHANGES / 3 || i == 2 * CHANGES / 3) {
                    server.kill();
                    server.start();
                }
                Thread.sleep(PACE_MILLIS);
            }
            for (Future<ChaosClient> client : running) clients.add(client.get(120, TimeUnit.SECONDS));
        } finally {
            threads.shutdownNow();
        }
        String told = told(clients);
        assertThat(clients).as(told).allMatch(client -> client.wrong == null);
        assertThat(clients.stream().mapToInt(client -> client.finished).sum())
                .as(told)
                .isGreaterThan(CLIENTS);
        assertThat(told).as("no fault of the server, but a full disk").doesNotContain("500=");
        assertMended();
        assertThat(server.output()).doesNotContain("Exception in thread");
        assertNothingHeld();
        server.stop();
        assertNothingLeft();
    }

    private void send(String id) throws InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(at(id + "?name=torus.ply"))
                .header("Authorization", "Bearer " + TOKEN)
                .POST(HttpRequest.BodyPublishers.ofString(Bumpy.torus(18), StandardCharsets.UTF_8))
                .build();
        try {
            http.send(request, HttpResponse.BodyHandlers.discarding());
        } catch (IOException e) {
            // The server is being killed.
        }
    }

    private HttpResponse<byte[]> get(String path) throws IOException, InterruptedException {
        return http.send(HttpRequest.newBuilder(at(path)).build(), HttpResponse.BodyHandlers.ofByteArray());
    }

    private static String told(List<ChaosClient> clients) {
        TreeMap<Integer, Integer> statuses = new TreeMap<>();
        StringBuilder text = new StringBuilder();
        int finished = 0;
        int broken = 0;
        for (ChaosClient client : clients) {
            client.statuses.forEach((status, count) -> statuses.merge(status, count, Integer::sum));
            finished += client.finished;
            broken += client.broken;
            if (client.wrong != null) text.append(client.wrong).append('\n');
        }
        return text + "answers " + statuses + ", whole downloads " + finished + ", broken connections " + broken;
    }

    /** Once the files are whole, every model is served, and the large one is told to be too much for the disk. */
    private void assertMended() throws Exception {
        chaos.mend();
        ChaosClient client = new ChaosClient(http, at(""), chaos.ids(), 0, Long.MAX_VALUE);
        for (String id : chaos.ids()) Await.until("the archive of " + id, () -> client.download(id));
        assertThat(client.wrong).isNull();
        Await.until(
                "a word on the large model", () -> get("large/manifest.json").statusCode() != 202);
        HttpResponse<byte[]> large = get("large/manifest.json");
        assertThat(large.statusCode()).isEqualTo(503);
        assertThat(large.headers().firstValue("Retry-After")).isPresent();
        assertThat(new String(large.body(), StandardCharsets.UTF_8)).contains("no room");
        Await.until("the end of uploads", () -> spool().isEmpty());
        for (String sent : List.of("sent-5", "sent-105"))
            assertThat(get(sent + "/manifest.json").statusCode()).isIn(200, 202);
    }

    /** Files that are gone are not held open. */
    private void assertNothingHeld() throws Exception {
        get("index.json");
        Path descriptors = Path.of("/proc", "" + server.pid(), "fd");
        Await.until("the end of all that is held of files that are gone", () -> {
            try (Stream<Path> open = Files.list(descriptors)) {
                return open.noneMatch(ChaosTest::isGone);
            }
        });
    }

    private static boolean isGone(Path descriptor) {
        try {
            String file = Files.readSymbolicLink(descriptor).toString();
            return file.endsWith(".jsm (deleted)") || file.endsWith(".ply (deleted)");
        } catch (IOException e) {
            return false; // it is closed by now
        }
    }

    private List<Path> spool() throws IOException {
        try (Stream<Path> files = Files.list(models.resolve("uploads/.spool"))) {
            return files.toList();
        }
    }

    private void assertNothingLeft() throws Exception {
        String mark = folder.toString();
        Await.until(
                "the end of all processes",
                () -> ProcessHandle.allProcesses()
                        .noneMatch(p -> p.info().commandLine().orElse("").contains(mark)));
        assertThat(folder.resolve("cache/.work")).isEmptyDirectory();
        try (Stream<Path> files = Files.walk(folder)) {
            assertThat(files.map(Path::toString).filter(f -> f.endsWith(".part") || f.endsWith(".inputs")))
                    .isEmpty();
        }
    }
}
