package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Flags go before the environment, the environment before the file, the file before defaults. */
class ConfigurationTest {
    @TempDir
    private Path folder;

    @Test
    void shouldTakeFlagsBeforeEnvironmentBeforeFileBeforeDefaults() throws IOException {
        Path file = Files.writeString(folder.resolve("jsm.properties"), "port = 1\nhost = 10.0.0.1\ncache = kept\n");
        Map<String, String> environment = Map.of("JSM_PORT", "2", "JSM_HOST", "10.0.0.2", "JSM_MODELS", "models");
        Cli cli = Cli.with(environment, "serve", "--config", file, "--port", "3", "--print-config");
        assertThat(cli.err()).isEmpty();
        assertThat(cli.code()).isZero();
        assertThat(cli.out().lines())
                .contains(
                        "port = 3  # flag",
                        "host = 10.0.0.2  # JSM_HOST",
                        "models = models  # JSM_MODELS",
                        "cache = kept  # " + file,
                        "management-port = -1  # default",
                        "config = " + file + "  # flag");
    }

    @Test
    void shouldFindTheFileByTheEnvironment() throws IOException {
        Path file = Files.writeString(folder.resolve("jsm.properties"), "port = 1234");
        Cli cli = Cli.with(Map.of("JSM_CONFIG", file.toString()), "serve", "--print-config");
        assertThat(cli.out().lines()).contains("port = 1234  # " + file);
    }

    @Test
    void shouldNotPrintSecrets() throws IOException {
        Path file = Files.writeString(folder.resolve("jsm.properties"), "keystore-password = sesame");
        Cli kept = Cli.with(Map.of(), "serve", "--print-config", "--config=" + file);
        assertThat(kept.out()).contains("keystore-password = ***  # " + file).doesNotContain("sesame");
        Cli told = Cli.with(Map.of("JSM_KEYSTORE_PASSWORD", "tahini"), "serve", "--print-config");
        assertThat(told.out())
                .contains("keystore-password = ***  # JSM_KEYSTORE_PASSWORD")
                .doesNotContain("tahini");
    }

    @Test
    void shouldSayWhereAWrongValueComesFrom() throws IOException {
        Cli variable = Cli.with(Map.of("JSM_PORT", "many"), "serve", folder);
        assertThat(variable.code()).isEqualTo(2);
        assertThat(variable.err()).contains("'many'", "JSM_PORT").hasLineCount(1);
        Path file = Files.writeString(folder.resolve("jsm.properties"), "port = few");
        Cli inFile = Cli.with(Map.of(), "serve", folder, "--config", file);
        assertThat(inFile.code()).isEqualTo(2);
        assertThat(inFile.err()).contains("'few'", file.toString()).hasLineCount(1);
    }

    @Test
    void shouldRefuseNamesThatMeanNothing() throws IOException {
        Path file = Files.writeString(folder.resolve("jsm.properties"), "prot = 1");
        Cli cli = Cli.with(Map.of(), "serve", folder, "--config", file);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains("no option prot").hasLineCount(1);
    }

    @Test
    void shouldNameAFileThatIsNotThere() {
        Path file = folder.resolve("none.properties");
        Cli cli = Cli.with(Map.of(), "serve", folder, "--config", file);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains(file.toString()).hasLineCount(1);
    }

    @Test
    void shouldAskForWhatToServe() {
        Cli cli = Cli.with(Map.of(), "serve");
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).contains("DIR_OR_FILE").hasLineCount(1);
    }
}
