package org.jsmesh.load;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.zip.GZIPInputStream;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ManagementServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;

/**
 * What a folder of many models costs a server; run as {@code java -cp jsm.jar:test-classes org.jsmesh.load.FolderCosts
 * FOLDER MODELS READY}. It fills the folder, which must be empty, with so many small archives, asks for so many of
 * them, and prints for requests over loopback the least wall time of 20 and the CPU time of the process by request,
 * then the heap by model.
 */
public final class FolderCosts {
    private static final int TIMES = 20;
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

    private final HttpClient client =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private String tag;

    private FolderCosts() {}

    public static void main(String[] args) throws Exception {
        new FolderCosts().run(Path.of(args[0]), Integer.parseInt(args[1]), Integer.parseInt(args[2]));
    }

    private void run(Path folder, int models, int ready) throws Exception {
        Path cache = Files.createTempDirectory("jsm-costs");
        ModelFilesEncoder encoder = new ModelFilesEncoder(EncoderSettings.defaults());
        Path triangle = Files.writeString(cache.resolve("triangle.obj"), TRIANGLE);
        Path encoded = cache.resolve("triangle.jsm");
        encoder.encode(triangle, encoded, ProgressListener.NONE);
        byte[] archive = Files.readAllBytes(encoded);
        Files.delete(encoded);
        for (int i = 0; i < models; i++) Files.write(folder.resolve(String.format("model-%06d.jsm", i)), archive);
        // Whatever classes and threads take is there before.
        try (ModelStore empty = new ModelStore(StoreSettings.of(cache).withCache(cache.resolve("c")), encoder)) {
            serve(empty, cache, 0, 0);
        }
        long before = heap();
        long begin = System.nanoTime();
        long cpu = cpu();
        try (ModelStore store = new ModelStore(StoreSettings.of(folder).withCache(cache.resolve("c")), encoder)) {
            System.out.printf(
                    Locale.ROOT,
                    "%-44s %9.2f ms %9.2f ms CPU%n",
                    "start",
                    (System.nanoTime() - begin) / 1e6,
                    (cpu() - cpu) / 1e6);
            System.out.printf(
                    Locale.ROOT, "%-44s %9.0f bytes%n", "heap by new model", (heap() - before) / (double) models);
            int asked = 0;
            for (int i = 0; i < ready; i++) {
                store.archive(store.find(String.format("model-%06d", i)).orElseThrow())
                        .join();
                asked++;
            }
            serve(store, folder, models, asked);
            long after = heap();
            System.out.printf(
                    Locale.ROOT,
                    "%-44s %9.0f bytes%n",
                    asked + " of " + models + " ready: heap by model",
                    (after - before) / (double) models);
        }
    }

    private void serve(ModelStore store, Path folder, int models, int ready) throws Exception {
        try (JsmServer server = JsmServer.start(ServerSettings.defaults().withAddress("127.0.0.1", 0), store);
                ManagementServer management = ManagementServer.start("127.0.0.1", 0, store, server)) {
            URI catalogue = server.uri().resolve("m/index.json");
            URI operation = URI.create("http://127.0.0.1:" + management.port() + "/");
            measure("catalogue, first page", models, () -> get(catalogue));
            measure("catalogue, first page, 304", models, () -> get(catalogue, "If-None-Match", tag));
            measure("catalogue, all pages", models, () -> walk(catalogue));
            if (models > 0)
                measure("catalogue, first page, after a change", models, () -> {
                    Path file = folder.resolve("model-000005.jsm");
                    Files.setLastModifiedTime(
                            file, java.nio.file.attribute.FileTime.fromMillis(System.nanoTime() / 1000));
                    String before = tag;
                    while (tag.equals(before)) get(catalogue);
                });
            measure(
                    "manifest of an unknown model",
                    models,
                    () -> get(server.uri().resolve("m/nobody/manifest.json")));
            measure("readiness", models, () -> get(operation.resolve("health/ready")));
            measure("metrics", models, () -> get(operation.resolve("metrics")));
        }
    }

    private interface Request {
        void run() throws Exception;
    }

    private void measure(String what, int models, Request request) throws Exception {
        long least = Long.MAX_VALUE;
        for (int i = 0; i < TIMES; i++) request.run();
        long cpu = cpu();
        for (int i = 0; i < TIMES; i++) {
            long begin = System.nanoTime();
            request.run();
            least = Math.min(least, System.nanoTime() - begin);
        }
        if (models == 0) return;
        System.out.printf(Locale.ROOT, "%-44s %9.2f ms %9.2f ms CPU%n", what, least / 1e6, (cpu() - cpu) / 1e6 / TIMES);
    }

    private byte[] get(URI address, String... headers) throws IOException, InterruptedException {
        HttpRequest.Builder request = HttpRequest.newBuilder(address).header("Accept-Encoding", "gzip");
        if (headers.length > 0) request.headers(headers);
        HttpResponse<byte[]> answer = client.send(request.build(), HttpResponse.BodyHandlers.ofByteArray());
        answer.headers().firstValue("ETag").ifPresent(t -> tag = t);
        return answer.body();
    }

    private void walk(URI catalogue) throws Exception {
        URI page = catalogue;
        while (page != null) {
            byte[] body = get(page);
            boolean isPacked = body.length > 1 && body[0] == 0x1f;
            byte[] text = isPacked ? new GZIPInputStream(new java.io.ByteArrayInputStream(body)).readAllBytes() : body;
            String head = new String(text, 0, Math.min(400, text.length));
            int next = head.indexOf("\"next\":\"");
            int start = next + "\"next\":\"".length();
            page = next < 0 ? null : catalogue.resolve(head.substring(start, head.indexOf('"', start)));
        }
    }

    private static long cpu() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                .getProcessCpuTime();
    }

    private static long heap() throws InterruptedException {
        for (int i = 0; i < 4; i++) {
            System.gc();
            Thread.sleep(100);
        }
        Runtime runtime = Runtime.getRuntime();
        return runtime.totalMemory() - runtime.freeMemory();
    }
}
