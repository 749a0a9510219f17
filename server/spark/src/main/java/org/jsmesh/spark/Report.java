package org.jsmesh.spark;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.apache.spark.api.java.JavaPairRDD;
import org.apache.spark.api.java.JavaSparkContext;
import org.jsmesh.site.RemovedModels;

/** Writes the report of a run, and what follows of it in the site. */
final class Report {
    private static final int MOST_ROWS = 20_000;
    private static final int FAILURES_TOLD = 20;

    private final JavaSparkContext spark;
    private final CatalogueSettings settings;
    private final Row.Stamp stamp;
    private final Ledger ledger;

    Report(JavaSparkContext spark, CatalogueSettings settings, Row.Stamp stamp, Ledger ledger) {
        this.spark = spark;
        this.settings = settings;
        this.stamp = stamp;
        this.ledger = ledger;
    }

    /** {@return names of the parts that were written, in the order of ids} */
    List<String> write(JavaPairRDD<String, Row> rows) {
        String report = settings.report();
        String run = stamp.run();
        long count = rows.count();
        int parts = (int) (1 + count / MOST_ROWS);
        return rows.sortByKey(true, parts)
                .values()
                .mapPartitionsWithIndex(
                        (index, part) -> {
                            List<Row> all = new ArrayList<>();
                            part.forEachRemaining(all::add);
                            Ledger writer = new Ledger(Worker.store(report));
                            return all.isEmpty()
                                    ? java.util.Collections.emptyIterator()
                                    : List.of(writer.writePart(run, index, all)).iterator();
                        },
                        true)
                .collect();
    }

    /** Removes the files of models that the catalogue does not name any more, since that time. */
    void remove(Set<String> ids, Instant since) {
        if (ids.isEmpty()) return;
        String site = settings.site();
        spark.parallelize(List.copyOf(ids), Math.min(ids.size(), 2 * spark.defaultParallelism()))
                .foreachPartition(part -> {
                    RemovedModels removed = new RemovedModels(Worker.store(site), since);
                    while (part.hasNext()) removed.remove(part.next());
                });
    }

    /** {@return the first rows of models that failed} */
    List<Row> failures(List<String> parts) throws IOException {
        List<Row> failures = new ArrayList<>();
        for (String part : parts) {
            if (failures.size() == FAILURES_TOLD) break;
            ledger.read(part, row -> {
                if (row.isFailed() && failures.size() < FAILURES_TOLD) failures.add(row);
            });
        }
        return failures;
    }
}
