package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ReproduceCommandTest {
    @TempDir
    private Path folder;

    @Test
    void shouldNameWhatItWrote() throws Exception {
        Path models = Files.createDirectories(folder.resolve("models"));
        for (String name : new String[] {"bunny", "dragon", "hand", "cessna", "fandisk"})
            Bumpy.write(models.resolve(name + ".ply"), 12);
        Path out = folder.resolve("out");
        Cli cli = Cli.ok("reproduce", "--models", models, "--only", "table2,figure9", "-o", out);
        assertThat(cli.out().lines())
                .containsExactly(
                        out.resolve("table2.md").toString(),
                        out.resolve("table2.csv").toString(),
                        out.resolve("figure9.png").toString(),
                        out.resolve("figure9.md").toString(),
                        out.resolve("README.md").toString());
        assertThat(cli.err()).isEmpty();
    }

    @Test
    void shouldSayThatThereIsNoFolderOfModels() {
        Cli cli = Cli.run("reproduce", "--models", folder.resolve("missing"), "-o", folder.resolve("out"));
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains(folder.resolve("missing") + ": no such folder. Give --models the folder");
        assertThat(folder.resolve("out")).doesNotExist();
    }

    @Test
    void shouldKnowItsParts() {
        Cli cli = Cli.run("reproduce", "--only", "table1,table6", "-o", folder.resolve("out"));
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).containsOnlyOnce("\n").contains("--only is table6", "table5, figure8");
    }
}
