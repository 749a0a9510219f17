package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.locks.LockSupport;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.storage.StorageLevel;
import org.jsmesh.app.Jsm;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.site.CatalogueRow;
import org.jsmesh.site.CatalogueWriter;
import org.jsmesh.test.Await;
import org.jsmesh.webapp.ViewerFiles;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs beside which others write, and whose cluster ends. */
@Tag("slow")
class DisturbedRunTest {
    private static final ObjectMapper JSON = new ObjectMapper();

    @TempDir
    private Path folder;

    private Path models;
    private Path site;
    private CatalogueSettings settings;

    @BeforeEach
    void makeModels() throws IOException {
        models = folder.resolve("models");
        site = folder.resolve("site");
        settings = Cluster.settings(models.toString(), site.toString());
        for (String name : List.of("a", "b", "c", "d"))
            Patches.write(models.resolve(name + ".ply"), 5, name.hashCode());
    }

    @Test
    void shouldLeaveAloneWhatOthersHavePublished() throws Exception {
        Cluster.run(settings);
        // Somebody publishes one of the models anew, and takes another away.
        Path other = folder.resolve("other");
        Patches.write(other.resolve("a.ply"), 8, 8);
        PrintWriter nowhere = new PrintWriter(new StringWriter());
        assertThat(Jsm.run(nowhere, nowhere, "encode", other.toString(), "--site", site.toString()))
                .isZero();
        new CatalogueWriter(new FolderObjectStore(site)).update(List.of(CatalogueRow.removal("b")));
        String catalogue = Files.readString(site.resolve("m/index.json"));
        List<Row> rows = Cluster.report(settings);
        // Then both files become bad; a second run was broken off.
        Files.writeString(models.resolve("a.ply"), "ply\nnonsense\n");
        Files.writeString(models.resolve("b.ply"), "ply\nnonsense\n");
        Patches.write(models.resolve("d.ply"), 9, 77);
        new Ledger(Worker.store(settings.report()))
                .writeJournal(Ledger.attempt("2000", 0, 1) + "0.json", List.of(RowParquetTest.failed("c")));
        Outcome outcome = Cluster.run(settings);
        assertThat(List.of(outcome.encoded(), outcome.failed(), outcome.published()))
                .containsExactly(2L, 2L, 3L);
        JsonNode before = JSON.readTree(catalogue).path("models");
        JsonNode after =
                JSON.readTree(Files.readString(site.resolve("m/index.json"))).path("models");
        assertThat(after.findValuesAsText("id")).containsExactly("a", "c", "d");
        assertThat(after.get(0)).isEqualTo(before.get(0));
        Row bad = Cluster.report(settings).stream()
                .filter(row -> row.id().equals("a"))
                .findFirst()
                .orElseThrow();
        assertThat(bad.isFailed()).isTrue();
        assertThat(rows).extracting(Row::entry).contains(bad.entry());
    }

    /** Works in vain until its executor ends. */
    private record Endless(String begun) implements ModelWork {
        private static final long serialVersionUID = 1;

        @Override
        public Row encode(PlannedModel model, int threads, ProgressListener progress) throws IOException {
            Files.writeString(Path.of(begun), "");
            while (!progress.isCancelled()) LockSupport.parkNanos(1_000_000);
            throw new CancellationException();
        }
    }

    @Test
    void shouldSayWhyWhenSparkIsStopped() throws Exception {
        Path begun = folder.resolve("begun");
        JavaSparkContext spark = Cluster.shared();
        JavaRDD<PlanRow> plan = spark.parallelize(List.<PlanRow>of()).persist(StorageLevel.DISK_ONLY());
        FutureTask<Void> stop = new FutureTask<>(() -> {
            Await.until("a model is begun", () -> Files.exists(begun));
            Cluster.stop();
            return null;
        });
        new Thread(stop).start();
        assertThatThrownBy(() -> CatalogueRun.run(
                        spark, settings, ViewerFiles.read(), (s, stamp, page) -> new Endless(begun.toString())))
                .isInstanceOf(CatalogueException.class)
                .hasMessageStartingWith("the run was broken off: ")
                .hasMessageContaining("SparkContext was shut down");
        stop.get();
        // Whatever is done at the end of a run must not hide why it ended.
        assertThatThrownBy(plan::unpersist).isInstanceOf(Exception.class);
        assertThatCode(() -> CatalogueRun.forget(plan)).doesNotThrowAnyException();
        assertThatThrownBy(() -> CatalogueRun.run(spark, settings, ViewerFiles.read(), EncodeModel::new))
                .isInstanceOf(CatalogueException.class)
                .hasMessageStartingWith("the run was broken off: ")
                .hasMessageContaining("stopped SparkContext");
        assertThat(Cluster.run(settings).encoded()).isEqualTo(4);
    }

    /** Ends another run, which saw the journals of this one when it began, before each model. */
    private record OtherRun(ModelWork work, String site, String report) implements ModelWork {
        private static final long serialVersionUID = 1;

        @Override
        public Row encode(PlannedModel model, int threads, ProgressListener progress)
                throws IOException, ModelChangedException {
            Ledger ledger = new Ledger(Worker.store(report));
            ledger.commit(JSON.createObjectNode().put("site", site), List.of(), ledger.start(), "other");
            return work.encode(model, threads, progress);
        }
    }

    @Test
    void shouldTellOfARunThatHasEndedMeanwhile() throws Exception {
        Path list = Files.writeString(
                folder.resolve("list.txt"), models.resolve("a.ply") + "\n" + models.resolve("gone.ply") + "\n");
        CatalogueSettings listed = new CatalogueSettings(
                List.of(),
                List.of(list.toString()),
                settings.site(),
                settings.report(),
                null,
                false,
                EncoderSettings.defaults());
        assertThatThrownBy(() -> Cluster.run(
                        listed,
                        (s, stamp, page) ->
                                new OtherRun(new EncodeModel(s, stamp, page), listed.site(), listed.report())))
                .isInstanceOf(CatalogueException.class)
                .hasMessageContaining("another run has ended meanwhile");
        Outcome again = Cluster.run(listed);
        assertThat(List.of(again.skipped(), again.encoded(), again.failed(), again.published()))
                .containsExactly(1L, 0L, 1L, 1L);
    }
}
