package org.jsmesh.site;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.stream.IntStream;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.objects.ObjectStore;

/**
 * What a catalogue of many models costs to write and to change: {@code CatalogueCosts EMPTY_FOLDER MODELS}.
 *
 * <p>Prints a line of Markdown for each step.
 */
public final class CatalogueCosts {
    private CatalogueCosts() {}

    public static void main(String[] args) throws IOException {
        Path folder = Path.of(args[0]);
        int models = Integer.parseInt(args[1]);
        System.out.println("| step | s | CPU s | heap, MB | find | read | put | MB read | MB written |");
        System.out.println("|---|--:|--:|--:|--:|--:|--:|--:|--:|");
        try (ObjectStore files = new FolderObjectStore(folder)) {
            CountingStore store = new CountingStore(files);
            Iterable<CatalogueRow> all = () -> IntStream.range(0, models)
                    .mapToObj(i -> row(String.format(Locale.ROOT, "model-%08d", i), i))
                    .iterator();
            step("write all", store, all);
            step("add one", store, List.of(row("model-00000500x", -1)));
            step("change one", store, List.of(row("model-00000500x", -2)));
            step("remove one", store, List.of(CatalogueRow.removal("model-00000500x")));
            step("add one at the end", store, List.of(row("zz", -1)));
            Iterable<CatalogueRow> some = () -> IntStream.range(0, models / 1000)
                    .mapToObj(i -> row(String.format(Locale.ROOT, "model-%08d", i * 1000L), -3 - i))
                    .iterator();
            step("change one in a thousand", store, some);
            step("write all again, nothing new but these", store, all);
        }
        long root = Files.size(folder.resolve("m/index.json"));
        System.out.println("\nm/index.json: " + root + " bytes");
    }

    private static void step(String name, CountingStore store, Iterable<CatalogueRow> changes) throws IOException {
        store.reset();
        System.gc();
        long before = heap();
        long cpu = cpu();
        long begin = System.nanoTime();
        long[] most = {0};
        // Looked at while the changes are gone through, after a collection each time.
        new CatalogueWriter(store).update(() -> watched(changes.iterator(), before, most));
        double seconds = (System.nanoTime() - begin) / 1e9;
        double cpuSeconds = (cpu() - cpu) / 1e9;
        System.out.printf(
                Locale.ROOT,
                "| %s | %.2f | %.2f | %.1f | %d | %d | %d | %.2f | %.2f |%n",
                name,
                seconds,
                cpuSeconds,
                most[0] / 1e6,
                store.counts().getOrDefault("find", 0),
                store.counts().getOrDefault("read", 0),
                store.counts().getOrDefault("put", 0),
                store.bytesRead() / 1e6,
                store.bytesWritten() / 1e6);
    }

    private static Iterator<CatalogueRow> watched(Iterator<CatalogueRow> rows, long before, long[] most) {
        return new Iterator<>() {
            private int count;

            @Override
            public boolean hasNext() {
                return rows.hasNext();
            }

            @Override
            public CatalogueRow next() {
                if (++count % 250_000 == 0) {
                    System.gc();
                    most[0] = Math.max(most[0], heap() - before);
                }
                return rows.next();
            }
        };
    }

    private static long heap() {
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }

    private static long cpu() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                .getProcessCpuTime();
    }

    /** As long as rows of models are. */
    private static CatalogueRow row(String id, int version) {
        Random random = new Random(id.hashCode() * 31L + version);
        String hash = String.format(Locale.ROOT, "%016x", random.nextLong()).repeat(4);
        String other = String.format(Locale.ROOT, "%016x", random.nextLong()).repeat(4);
        String json = "{\"id\":\"" + id + "\",\"name\":\"" + id + "\",\"format\":\"jsm\",\"fileBytes\":123456,"
                + "\"manifestUrl\":\"" + id + "/manifest.json\",\"state\":\"ready\",\"archiveUrl\":\"" + id + "/"
                + hash + ".jsm\",\"posterUrl\":\"" + id + "/" + hash + "/poster.jpg\",\"archiveSha256\":\"" + hash
                + "\",\"meshSha256\":\"" + other + "\",\"bytes\":123456,\"faces\":34567,\"vertices\":17285,"
                + "\"baseFaces\":345,\"baseBytes\":1234,\"materials\":1,\"textures\":0,"
                + "\"bounds\":[-0.5234375,-0.25,-1.0,0.5234375,0.25,1.0],\"modified\":\"2026-11-30T12:00:00Z\"}";
        return new CatalogueRow(id, json);
    }
}
