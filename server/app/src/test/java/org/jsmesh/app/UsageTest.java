package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class UsageTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"encode", "decode", "info", "verify", "fetch", "simulate", "bench", "reproduce", "serve"})
    void shouldExplainEachCommandWithAnExample(String command) {
        Cli cli = Cli.run(command, "--help");
        assertThat(cli.code()).isZero();
        assertThat(cli.out()).contains("Usage: jsm " + command, "Example").contains("jsm " + command + " ");
        assertThat(cli.err()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "'' | no command",
                "encode | INPUT",
                "encode x.ply | --output",
                "encode x.ply -o x.jsm --no-such | --no-such",
                "encode x.ply -o x.jsm --threads 0 | --threads is 0",
                "encode x.ply -o x.jsm --base-faces -1 | --base-faces is -1",
                "encode x.ply -o x.jsm --simplifier best | use quadric or paper",
                "encode x.ply -o x.jsm --quality good | use fast, default or best",
                "encode x.ply -o x.jsm --simplifier paper --quality best | --quality goes with --simplifier quadric",
                "encode x.ply -o x.jsm --levels .2 | --levels goes with --simplifier paper",
                "encode x.ply -o x.jsm --simplifier paper --levels .2,much | is no threshold",
                "encode x.ply -o x.jsm --simplifier paper --levels .4,.2 | ascend",
                "encode x.ply -o x.jsm --simplifier paper --levels 0 | above 0",
                "encode x.ply -o x.jsm --simplifier paper --levels NaN | ascend",
                "decode x.jsm -o x.doc | no known extension",
                "decode x.jsm -o x.ply --faces 3 --batch 1 | mutually exclusive",
                "decode x.jsm -o x.ply --error much | no percentage",
                "simulate x.jsm | --kbps",
                "simulate x.jsm --kbps 0 | --kbps is 0",
                "simulate x.jsm --kbps 64 --wait soon | no time such as 2s",
                "nonsense | nonsense"
            })
    void shouldAnswerWrongUsageInOneLineWithCode2(String line, String reason) {
        Cli cli = Cli.run((Object[]) (line.isEmpty() ? new String[0] : line.split(" ")));
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).containsOnlyOnce("\n").contains(reason, "--help");
        assertThat(cli.out()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "decode %s -o x.ply",
                "info %s",
                "verify %s x.ply",
                "simulate %s --kbps 64",
                "bench %s",
                "encode %s -o x.jsm"
            })
    void shouldNameAMissingFileInOneLineWithCode1(String line) {
        Path missing = folder.resolve("missing.jsm");
        Cli cli = Cli.run((Object[]) String.format(line, missing).split(" "));
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).containsOnlyOnce("\n").contains(missing + ": no such file. Check the path.");
    }

    @Test
    void shouldSayThatAFileIsNoArchive() throws Exception {
        Path text = Files.writeString(
                folder.resolve("text.jsm"), "this is no archive at all, whatever its name says\n".repeat(100));
        Cli cli = Cli.run("info", text);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).containsOnlyOnce("\n").contains(text.toString(), "not a whole archive");
    }
}
