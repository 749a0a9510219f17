package org.jsmesh.spark;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.apache.spark.api.java.JavaSparkContext;
import org.jsmesh.files.Explanation;
import org.jsmesh.objects.ObjectContent;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.objects.Upload;

/** Tries what a run needs, in executors too, so that a right that is missing is told before work begins. */
final class Rights {
    private static final String TRIAL = "jsm-trial-";
    private static final int MOST_STORES = 100;

    private Rights() {}

    /**
     * Tries.
     *
     * @param run whose objects are its own, as another may begin or end at the same time
     * @param files among the inputs, see {@link Packed}
     */
    static void check(JavaSparkContext spark, CatalogueSettings settings, String run, List<byte[]> files)
            throws CatalogueException, IOException {
        if (files.isEmpty()) return;
        List<Integer> tasks = IntStream.range(0, Math.max(1, spark.defaultParallelism()))
                .boxed()
                .toList();
        byte[] some = Packed.listed(samples(files));
        ObjectStore report = Worker.store(settings.report());
        Set<String> told;
        report.put(Upload.of(TRIAL + run, ObjectContent.of(new byte[0])));
        try {
            told = new LinkedHashSet<>(spark.parallelize(tasks, tasks.size())
                    .map(task -> trial(settings, run, Packed.listed(some), task))
                    .filter(text -> !text.isEmpty())
                    .collect());
        } finally {
            report.delete(TRIAL + run);
        }
        if (!told.isEmpty())
            throw new CatalogueException("executors cannot do what is asked of them: " + String.join(" ", told)
                    + " Give executors the rights of the driver, and the same folders");
    }

    /** {@return a file of each store, of the first ones where there are many} */
    static List<ListedModel> samples(List<byte[]> files) {
        Map<String, ListedModel> byStore = new LinkedHashMap<>();
        for (byte[] packed : files) {
            for (ListedModel file : Packed.listed(packed)) byStore.putIfAbsent(file.store(), file);
            if (byStore.size() >= MOST_STORES) break;
        }
        return byStore.values().stream().limit(MOST_STORES).toList();
    }

    /** Empty when all is well. */
    static String trial(CatalogueSettings settings, String run, List<ListedModel> files, int task) {
        String about = "";
        try {
            for (ListedModel file : files) {
                about = file.input();
                ObjectStore inputs = Worker.store(file.store());
                StoredObject found = inputs.find(file.key()).orElse(null);
                if (found != null && found.bytes() > 0) inputs.read(found, 0, ByteBuffer.allocate(1));
            }
            about = settings.report();
            if (Worker.store(about).find(TRIAL + run).isEmpty())
                return about + ": is another folder on other machines.";
            for (String place : new String[] {settings.report(), settings.site()}) {
                about = place;
                ObjectStore store = Worker.store(place);
                store.put(Upload.of(TRIAL + run + "-" + task, ObjectContent.of(new byte[0])));
                store.delete(TRIAL + run + "-" + task);
            }
            return "";
        } catch (IOException | RuntimeException e) {
            return Explanation.of(about, e).toString();
        }
    }
}
