package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jsmesh.app.Jsm;
import org.jsmesh.encode.EncoderSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("slow")
class CatalogueRunTest {
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
        for (int i = 0; i < 9; i++) Patches.write(models.resolve("d" + i % 3 + "/Model " + i + ".ply"), 4 + i, i);
        Patches.write(models.resolve("椅子.ply"), 5, 1);
        Patches.write(models.resolve("same.ply"), 5, 2);
        Patches.writeObj(models.resolve("same.obj"), 6, "Same.MTL");
        Files.writeString(models.resolve("same.mtl"), "newmtl red\nKd 1 0 0\nmap_Kd missing.png\n");
        Files.writeString(models.resolve("d0/Model 0.annotations.json"), "{\"annotations\": []}");
    }

    @Test
    void shouldWriteTheFilesThatTheCommandWritesThenOnlyWhatChanges() throws Exception {
        Files.writeString(models.resolve("bad.ply"), "ply\nnonsense\n");
        Outcome first = Cluster.run(settings);
        assertThat(List.of(first.listed(), first.encoded(), first.failed())).containsExactly(13L, 12L, 1L);
        Row.Failure bad = first.failures().get(0).failure();
        assertThat(bad.place()).startsWith(models.resolve("bad.ply") + ", line");
        assertThat(bad.reason()).isNotEmpty();
        assertThat(bad.remedy()).isNotEmpty();

        Path other = folder.resolve("other");
        PrintWriter nowhere = new PrintWriter(new StringWriter());
        assertThat(Jsm.run(nowhere, nowhere, "encode", models.toString(), "--site", other.toString()))
                .isEqualTo(1);
        SortedMap<String, String> expected = files(other);
        assertThat(expected.keySet()).anyMatch(name -> name.endsWith("annotations.json"));
        SortedMap<String, String> before = files(site);
        assertThat(before).isEqualTo(expected);
        try (Stream<Path> all = Files.walk(folder)) {
            assertThat(all.map(Path::toString)).noneMatch(name -> name.endsWith(".crc"));
        }

        Outcome second = Cluster.run(settings);
        assertThat(List.of(second.skipped(), second.encoded(), second.failed())).containsExactly(12L, 0L, 1L);
        assertThat(files(site)).isEqualTo(before);

        Patches.write(models.resolve("d1/Model 1.ply"), 9, 77);
        Files.writeString(models.resolve("same.mtl"), "newmtl red\nKd 0 1 0\n");
        Files.writeString(models.resolve("d0/Model 0.annotations.json"), "{\"annotations\": [{}]}");
        Files.delete(models.resolve("d2/Model 2.ply"));
        Patches.write(models.resolve("bad.ply"), 4, 4);
        Outcome third = Cluster.run(settings);
        assertThat(List.of(third.skipped(), third.encoded(), third.failed(), third.published()))
                .containsExactly(8L, 4L, 0L, 13L);
        assertThat(Cluster.report(settings).stream()
                        .filter(row -> row.stamp().run().equals(third.run()))
                        .map(Row::id))
                .containsExactly("bad", "d0--model-0", "d1--model-1", "same");

        Outcome fourth = Cluster.run(new CatalogueSettings(
                settings.inputs(),
                List.of(),
                settings.site(),
                settings.report(),
                null,
                true,
                EncoderSettings.defaults().withPoster(false)));
        assertThat(List.of(fourth.encoded(), fourth.removed(), fourth.published()))
                .containsExactly(12L, 1L, 12L);
        assertThat(site.resolve("m/d2--model-2")).doesNotExist();
        assertThat(site.resolve("m/d1--model-1")).isDirectory();
    }

    /** Of every file a hash of the content, in which the time of publishing says nothing. */
    private static SortedMap<String, String> files(Path site) throws IOException {
        SortedMap<String, String> files = new TreeMap<>();
        List<Path> all;
        try (Stream<Path> walk = Files.walk(site)) {
            all = walk.filter(Files::isRegularFile).toList();
        }
        for (Path file : all) {
            String name = site.relativize(file).toString();
            byte[] content = Files.readAllBytes(file);
            if (name.equals("m/index.json")) {
                JsonNode page = JSON.readTree(content);
                page.path("models").forEach(row -> ((ObjectNode) row).remove("modified"));
                files.put(name, page.toString());
            } else if (!name.startsWith(".")) {
                files.put(name, content.length + " " + Arrays.hashCode(content));
            }
        }
        return files;
    }

    @Test
    void shouldSurviveTheLossOfExecutorsAndOfTheirMemory() throws Exception {
        Outcome outcome = Cluster.run(
                settings,
                (s, stamp, page) -> new HardWork(
                        new EncodeModel(s, stamp, page), "d1--model-4", "d2--model-5", "d0--model-3", "same"));
        assertThat(List.of(outcome.encoded(), outcome.failed())).containsExactly(10L, 2L);
        assertThat(Cluster.report(settings)).hasSize(12);
        assertThat(outcome.failures()).extracting(Row::id).containsExactly("d2--model-5", "same");
        assertThat(outcome.failures().get(0).failure().reason()).contains("executors were lost");
        Row.Failure exhausted = outcome.failures().get(1).failure();
        assertThat(exhausted.reason()).contains("needs more memory", "alone");
        assertThat(exhausted.remedy()).contains("--executor-memory");
        // Both are worth another try.
        Outcome again = Cluster.run(settings);
        assertThat(List.of(again.skipped(), again.encoded(), again.failed())).containsExactly(10L, 2L, 0L);
    }

    @Test
    void shouldSayWhyItBrokeOffThenGoOn() throws Exception {
        Outcome before = Cluster.run(settings);
        Patches.write(models.resolve("d1/Model 1.ply"), 9, 77);
        // Where the executors' journals go.
        Path journals = folder.resolve("site-report/journal");
        Files.writeString(journals, "not a folder");
        assertThatThrownBy(() -> Cluster.run(settings))
                .isInstanceOf(CatalogueException.class)
                .hasMessageContaining("the run was broken off: ")
                .hasMessageContaining("journal")
                .hasMessageEndingWith("run again: it goes on from here");
        Files.delete(journals);
        Outcome outcome = Cluster.run(settings);
        assertThat(List.of(outcome.encoded(), outcome.published())).containsExactly(1L, before.published());
    }

    @Test
    void shouldTakeAListWithPlaces() throws Exception {
        Path list = folder.resolve("list.txt");
        String first = models.resolve("d0/Model 0.ply").toString();
        String second = models.resolve("d1/Model 1.ply").toString();
        Files.writeString(
                list, first + "\tchairs/oak.ply\n" + second + "\n\n# none\n" + models.resolve("gone.ply") + "\n");
        CatalogueSettings listed = new CatalogueSettings(
                List.of(),
                List.of(list.toString()),
                site.toString(),
                settings.report(),
                null,
                false,
                EncoderSettings.defaults());
        assertThat(Cluster.run(listed).encoded()).isEqualTo(2);
        // A site that is gone is made anew, whatever the report says.
        try (Stream<Path> all = Files.walk(site)) {
            for (Path file : all.sorted(java.util.Comparator.reverseOrder()).toList()) Files.delete(file);
        }
        Outcome outcome = Cluster.run(listed);
        assertThat(outcome.encoded()).isEqualTo(2);
        assertThat(site.resolve("m/model-1/manifest.json")).isRegularFile();
        assertThat(Cluster.report(listed).stream()
                        .filter(row -> !row.isFailed())
                        .map(Row::id))
                .containsExactly("chairs--oak", "model-1");
        assertThat(outcome.failures().get(0).failure().reason()).isEqualTo("is not there");

        Files.writeString(list, first + "\tx.ply\n" + second + "\tx.ply\n");
        assertThatThrownBy(() -> Cluster.run(listed)).hasMessageContaining("are both x.ply");
        CatalogueSettings elsewhere =
                Cluster.settings(models.toString(), folder.resolve("elsewhere").toString());
        assertThatThrownBy(() -> Cluster.run(new CatalogueSettings(
                        elsewhere.inputs(),
                        List.of(),
                        elsewhere.site(),
                        settings.report(),
                        null,
                        false,
                        EncoderSettings.defaults())))
                .isInstanceOf(CatalogueException.class)
                .hasMessageContaining("is the report of the site " + site);
    }
}
