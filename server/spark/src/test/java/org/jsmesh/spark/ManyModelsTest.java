package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("long")
class ManyModelsTest {
    private static final int MODELS = 2000;

    @TempDir
    private Path folder;

    @Test
    void shouldEncodeAllThoughAnExecutorIsLostInTheMiddle() throws Exception {
        for (int i = 0; i < MODELS; i++)
            Patches.write(folder.resolve("models/d" + i % 40 + "/m" + i + ".ply"), 4 + i % 5, i);
        CatalogueSettings settings = Cluster.settings(
                folder.resolve("models").toString(), folder.resolve("site").toString());
        Outcome outcome = Cluster.run(
                settings, (s, stamp, page) -> new HardWork(new EncodeModel(s, stamp, page), "d1--m1001", "", "", ""));
        assertThat(List.of(outcome.encoded(), outcome.failed(), outcome.published()))
                .containsExactly(2000L, 0L, 2000L);
        List<Row> rows = Cluster.report(settings);
        assertThat(rows).hasSize(MODELS);
        for (Row row : rows)
            assertThat(Files.size(Path.of(row.facts().output())))
                    .isEqualTo(row.facts().bytes());
        assertThat(folders()).isEqualTo(MODELS);
        Outcome again = Cluster.run(settings);
        assertThat(List.of(again.skipped(), again.encoded())).containsExactly(2000L, 0L);
    }

    private long folders() throws IOException {
        try (Stream<Path> all = Files.list(folder.resolve("site/m"))) {
            return all.filter(Files::isDirectory).count();
        }
    }
}
