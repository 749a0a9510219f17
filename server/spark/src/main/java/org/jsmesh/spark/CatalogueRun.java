package org.jsmesh.spark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import org.apache.spark.SparkException;
import org.apache.spark.api.java.JavaPairRDD;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.storage.StorageLevel;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.site.CatalogueWriter;
import org.jsmesh.site.StaticSite;

/**
 * A run over a catalogue, seen from the driver. Lists the inputs; compares them with the report of the last run, and
 * reads the headers of what is new (in executors); encodes that in bins, largest models first; puts what ran out of
 * memory once more, alone; writes report and catalogue.
 *
 * <p>The driver holds 30 to 60 bytes a model. What tasks leave for each other lies in the store of the report, so that
 * the loss of an executor costs no more than the tasks that it had.
 */
final class CatalogueRun {
    private static final DateTimeFormatter NAME =
            DateTimeFormatter.ofPattern("yyyyMMdd'T'HHmmssSSS'Z'").withZone(ZoneOffset.UTC);

    private final JavaSparkContext spark;
    private final CatalogueSettings settings;
    private final Row.Stamp stamp;
    private final Ledger ledger;
    private final ModelWork work;

    private CatalogueRun(JavaSparkContext spark, CatalogueSettings settings, Row.Stamp stamp, ModelWork work)
            throws IOException {
        this.spark = spark;
        this.settings = settings;
        this.stamp = stamp;
        this.work = work;
        ledger = new Ledger(Worker.store(settings.report()));
    }

    /** Makes what is done with the models of a run. */
    @FunctionalInterface
    interface Works {
        ModelWork of(CatalogueSettings settings, Row.Stamp stamp, byte[] page);
    }

    /**
     * Runs.
     *
     * @param page files of the page by their paths relative to the site
     * @param works {@code EncodeModel::new} but in tests
     * @throws CatalogueException when it cannot be done, with place, reason and remedy
     */
    static Outcome run(JavaSparkContext spark, CatalogueSettings settings, SortedMap<String, byte[]> page, Works works)
            throws CatalogueException {
        Row.Stamp stamp = new Row.Stamp(NAME.format(Instant.now()), settings.key(), ModelEncoding.VERSION);
        ModelWork work = works.of(settings, stamp, page.get("index.html"));
        try (StaticSite site = StaticSite.open(ObjectStores.open(settings.site()), page)) {
            return new CatalogueRun(spark, settings, stamp, work).run(site.at(settings.publicUrl()));
        } catch (IOException | IllegalArgumentException e) {
            throw Listing.failed(settings.site(), e);
        } catch (SparkException | UncheckedIOException | IllegalStateException e) {
            // The last of them where Spark was stopped.
            throw CatalogueException.brokenOff(settings.site(), e);
        }
    }

    private Outcome run(StaticSite site) throws CatalogueException, IOException, SparkException {
        Ledger.Start before = ledger.start();
        if (before.summary() != null) checkSite(before.summary());
        Listing listing = new Listing();
        for (String input : settings.inputs()) listing.input(input);
        for (String list : settings.lists()) listing.list(list);
        List<byte[]> files = listing.packed();
        if (settings.prune() && listing.count() == 0)
            throw new CatalogueException("--prune: no model was listed, and all would go. Give inputs");
        // Of a site that is gone the report says nothing; every run leaves a catalogue, an empty one at least.
        boolean isThere = Worker.store(settings.site()).find("m/index.json").isPresent();
        Rights.check(spark, settings, stamp.run(), files);
        // The page first: those of models need its files, and it is known then that the driver may write.
        site.finish();
        Stages stages = new Stages(spark, settings, stamp);
        JavaPairRDD<String, Row> known = stages.rows(isThere ? before.parts() : List.of(), before.rows());
        JavaRDD<PlanRow> plan = stages.plan(stages.ids(files), known).persist(StorageLevel.DISK_ONLY());
        try {
            return run(before, listing.count(), known, plan, stages);
        } catch (IOException | SparkException | UncheckedIOException e) {
            // What the other run has removed, this one may have missed.
            if (hasAnotherEnded(before, e))
                throw new CatalogueException(
                        settings.report() + ": another run has ended meanwhile, whose report it is now."
                                + " Run again: what this one did is known then",
                        e);
            throw e;
        } finally {
            forget(plan);
        }
    }

    private boolean hasAnotherEnded(Ledger.Start before, Exception e) {
        try {
            return ledger.hasChangedSince(before);
        } catch (IOException again) {
            e.addSuppressed(again);
            return false;
        }
    }

    static void forget(JavaRDD<PlanRow> plan) {
        // Scala's code throws checked exceptions that it does not declare.
        Callable<JavaRDD<PlanRow>> unpersist = plan::unpersist;
        try {
            unpersist.call();
        } catch (Exception e) {
            // Where Spark was stopped there is nothing left, and what stopped it is told already.
        }
    }

    private void checkSite(Ledger.Summary before) throws CatalogueException {
        String other = before.content().path("site").asText();
        if (!other.equals(settings.site()))
            throw new CatalogueException(settings.report() + ": is the report of the site " + other + ", not of "
                    + settings.site() + ". Choose another place with --report, or that site");
    }

    private Outcome run(
            Ledger.Start before, long listed, JavaPairRDD<String, Row> known, JavaRDD<PlanRow> plan, Stages stages)
            throws IOException, SparkException {
        Map<PlanRow.Kind, Long> counts = new EnumMap<>(PlanRow.Kind.class);
        // By name: the hash of a kind is another one in every process, so those of one kind would not meet.
        plan.map(row -> row.kind().name())
                .countByValue()
                .forEach((name, count) -> counts.put(PlanRow.Kind.valueOf(name), count));
        long refused = counts.getOrDefault(PlanRow.Kind.REFUSED, 0L);
        long wanted = counts.getOrDefault(PlanRow.Kind.ENCODE, 0L);
        List<String> journals = new ArrayList<>();
        if (refused > 0) journals.addAll(stages.refuse(plan));
        Stages.Encoded encoded = wanted > 0 ? stages.encode(plan, work) : new Stages.Encoded(0, List.of());
        journals.addAll(encoded.journals());
        Set<String> gone = settings.prune() ? absent(plan, counts, PlanRow.Kind.ABSENT, stages) : Set.of();
        Set<String> dropped = new HashSet<>(gone);
        dropped.addAll(absent(plan, counts, PlanRow.Kind.FORGOTTEN, stages));
        Report report = new Report(spark, settings, stamp, ledger);
        List<String> parts = report.write(stages.merge(known, stages.rows(journals, refused + wanted), dropped));
        Set<String> runs = new HashSet<>(before.openRuns());
        runs.add(stamp.run());
        CatalogueChanges changes = new CatalogueChanges(ledger, parts, gone, runs);
        CatalogueWriter writer = new CatalogueWriter(Worker.store(settings.site()));
        long published = writer.update(changes).total();
        long failed = refused + counts.getOrDefault(PlanRow.Kind.KEPT_FAILURE, 0L) + wanted - encoded.count();
        long skipped = counts.getOrDefault(PlanRow.Kind.KEPT, 0L);
        Outcome outcome = new Outcome(
                stamp.run(), listed, skipped, encoded.count(), failed, gone.size(), published, report.failures(parts));
        ledger.commit(outcome.toJson(settings), parts, before, stamp.run());
        // Behind the report: it must not tell of what is not there.
        report.remove(gone, writer.time());
        return outcome;
    }

    private static Set<String> absent(
            JavaRDD<PlanRow> plan, Map<PlanRow.Kind, Long> counts, PlanRow.Kind kind, Stages stages) {
        return counts.containsKey(kind) ? stages.absent(plan, kind) : Set.of();
    }
}
