package org.jsmesh.spark;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import org.apache.spark.api.java.JavaPairRDD;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.api.java.JavaSparkContext;
import scala.Tuple2;

/** The parts of a run that executors do. */
final class Stages {
    /** Of a task: long enough to be worth sending, and short enough to be lost. */
    private static final double LONGEST_SECONDS = 60;

    private static final double SHORTEST_SECONDS = .5;
    private static final int BINS_A_CORE = 16;
    private static final int DUPLICATES_TOLD = 5;

    private final JavaSparkContext spark;
    private final CatalogueSettings settings;
    private final Row.Stamp stamp;

    Stages(JavaSparkContext spark, CatalogueSettings settings, Row.Stamp stamp) {
        this.spark = spark;
        this.settings = settings;
        this.stamp = stamp;
    }

    private int cores() {
        return Math.max(1, spark.defaultParallelism());
    }

    /** So many that a core has a few, and that each has some thousand rows at most. */
    private int slices(long items) {
        return (int) Math.max(1, Math.min(items, Math.max(2L * cores(), items / Packed.MOST)));
    }

    private <T> JavaRDD<T> distribute(List<T> items) {
        return spark.parallelize(items, Math.max(1, items.size()));
    }

    /**
     * Reads rows.
     *
     * @param parts of a report
     * @param count how many rows they have, about
     * @return the rows by id; of equal ids what the last part says, see {@link Row#then}
     */
    JavaPairRDD<String, Row> rows(List<String> parts, long count) {
        String report = settings.report();
        List<Tuple2<Integer, String>> numbered = new ArrayList<>();
        for (String part : parts) numbered.add(new Tuple2<>(numbered.size(), part));
        JavaPairRDD<String, Tuple2<Integer, Row>> rows = distribute(numbered).flatMapToPair(part -> {
            List<Tuple2<String, Tuple2<Integer, Row>>> found = new ArrayList<>();
            new Ledger(Worker.store(report))
                    .read(part._2(), row -> found.add(new Tuple2<>(row.id(), new Tuple2<>(part._1(), row))));
            return found.iterator();
        });
        return rows.groupByKey(slices(count)).mapValues(Stages::last);
    }

    /** {@return what the last of these says, of which the numbers tell the order} */
    static Row last(Iterable<Tuple2<Integer, Row>> rows) {
        List<Tuple2<Integer, Row>> sorted = new ArrayList<>();
        rows.forEach(sorted::add);
        sorted.sort(Comparator.comparing(Tuple2::_1));
        Row last = sorted.get(0)._2();
        for (Tuple2<Integer, Row> row : sorted.subList(1, sorted.size())) last = last.then(row._2());
        return last;
    }

    /**
     * Gives files ids.
     *
     * @param files see {@link Packed}
     * @throws CatalogueException when two files have one place
     */
    JavaPairRDD<String, ListedModel> ids(List<byte[]> files) throws CatalogueException {
        int slices = Math.max(2 * cores(), files.size());
        JavaRDD<ListedModel> all =
                distribute(files).flatMap(packed -> Packed.listed(packed).iterator());
        List<String> taken = all.mapToPair(file -> new Tuple2<>(file.place(), SamePlace.of(file)))
                .reduceByKey(SamePlace::and, slices)
                .filter(place -> place._2().isTaken())
                .map(place -> place._2().said(place._1()))
                .take(DUPLICATES_TOLD);
        if (!taken.isEmpty())
            throw new CatalogueException(String.join("; ", taken)
                    + ": their ids would be the same. In a list, give each a place of its own behind a tab");
        JavaRDD<Ids.Given> given = all.groupBy(Ids::first, slices)
                .values()
                .flatMap(group -> Ids.assign(group).iterator());
        return given.groupBy(Ids.Given::id, slices)
                .values()
                .flatMap(group -> Ids.separate(group).iterator())
                .mapToPair(g -> new Tuple2<>(g.id(), g.file()));
    }

    /** {@return what is to be done, for each model among the inputs and in the last report} */
    JavaRDD<PlanRow> plan(JavaPairRDD<String, ListedModel> ids, JavaPairRDD<String, Row> known) {
        PlanTask task = new PlanTask(settings, stamp);
        return ids.cogroup(known, most(ids, known))
                .map(model -> task.plan(
                        model._1(), first(model._2()._1()), first(model._2()._2())));
    }

    /** Without a number Spark may take that of the side which has but one part. */
    private static int most(JavaPairRDD<?, ?> a, JavaPairRDD<?, ?> b) {
        return Math.max(a.getNumPartitions(), b.getNumPartitions());
    }

    private static <T> T first(Iterable<T> items) {
        Iterator<T> i = items.iterator();
        return i.hasNext() ? i.next() : null;
    }

    /**
     * Writes the rows of what cannot be encoded.
     *
     * @return names of the journals with them
     */
    List<String> refuse(JavaRDD<PlanRow> plan) {
        String report = settings.report();
        String run = stamp.run();
        return plan.filter(row -> row.is(PlanRow.Kind.REFUSED))
                .map(PlanRow::row)
                .mapPartitionsWithIndex(
                        (index, rows) -> {
                            List<Row> refused = new ArrayList<>();
                            rows.forEachRemaining(refused::add);
                            if (refused.isEmpty()) return java.util.Collections.emptyIterator();
                            String journal =
                                    Ledger.refused(run, index, Attempt.current().id());
                            new Ledger(Worker.store(report)).writeJournal(journal, refused);
                            return List.of(journal).iterator();
                        },
                        false)
                .collect();
    }

    /**
     * Encodes what there is to encode, and what did not fit beside others once more, alone.
     *
     * @return how many models were encoded, and names of the journals with the rows of all, in order
     */
    Encoded encode(JavaRDD<PlanRow> plan, ModelWork work) {
        JavaRDD<PlannedModel> models =
                plan.filter(row -> row.is(PlanRow.Kind.ENCODE)).map(PlanRow::planned);
        double seconds = models.mapToDouble(PlannedModel::seconds).sum();
        double wanted = Math.max(SHORTEST_SECONDS, Math.min(LONGEST_SECONDS, seconds / cores() / BINS_A_CORE));
        List<byte[]> packed = models.sortBy(m -> -m.seconds(), true, Math.max(1, models.getNumPartitions() / 8))
                .mapPartitions(sorted -> Bin.cut(sorted, wanted))
                .collect();
        List<Bin> bins = new ArrayList<>();
        for (byte[] bin : packed) bins.add(new Bin(bins.size(), bin));
        List<BinTask.Result> results = run(bins, work, false);
        List<Bin> alone = new ArrayList<>();
        for (BinTask.Result result : results)
            for (PlannedModel model : Packed.planned(result.exhausted()))
                alone.add(new Bin(bins.size() + alone.size(), Packed.planned(List.of(model))));
        List<BinTask.Result> all = new ArrayList<>(results);
        if (!alone.isEmpty()) all.addAll(run(alone, work, true));
        return new Encoded(
                all.stream().mapToLong(BinTask.Result::encoded).sum(),
                all.stream().flatMap(result -> result.journals().stream()).toList());
    }

    /**
     * What was done.
     *
     * @param count of models
     * @param journals with the rows of these and of those that failed, the last of a model behind its others
     */
    record Encoded(long count, List<String> journals) {}

    private List<BinTask.Result> run(List<Bin> bins, ModelWork work, boolean alone) {
        BinTask task = new BinTask(work, settings.report(), stamp, Worker.coresToTake(spark.getConf()), alone);
        return distribute(bins).map(bin -> task.run(bin, Attempt.current())).collect();
    }

    /** {@return ids of models of this kind, which are in the last report and not among the inputs} */
    Set<String> absent(JavaRDD<PlanRow> plan, PlanRow.Kind kind) {
        return Set.copyOf(
                plan.filter(row -> row.is(kind)).map(row -> row.row().id()).collect());
    }

    /**
     * The rows of the next report.
     *
     * @param known those of the last one
     * @param added those of this run, which replace them
     * @param gone ids of models that go
     */
    JavaPairRDD<String, Row> merge(JavaPairRDD<String, Row> known, JavaPairRDD<String, Row> added, Set<String> gone) {
        return known.cogroup(added, most(known, added))
                .filter(model -> !gone.contains(model._1()))
                .mapValues(rows -> merged(first(rows._1()), first(rows._2())));
    }

    private static Row merged(Row before, Row now) {
        if (now == null) return before;
        return before == null ? now : before.then(now);
    }
}
