package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.jar.Attributes;
import org.jsmesh.test.BuiltJar;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** {@code jsm.jar} as it was built. */
@Timeout(120)
class RunnableJarIT {
    private static final BuiltJar JAR = new BuiltJar(Path.of("target", "jsm.jar"));

    @Test
    void shouldHoldLicenceVersionAndTheTimeOfEveryBuild() throws Exception {
        JAR.assertPublishable(Path.of("..", "..", "LICENSE"));
    }

    @Test
    void shouldNameTheLibrariesInIt() throws Exception {
        JAR.assertNamesLibraries();
        assertThat(JAR.text("META-INF/THIRD-PARTY.txt")).contains("* three.js ", "---- three.js: ", "* TeaVM ");
        assertThat(JAR.text("META-INF/NOTICE")).contains("Copyright 2026 The jSM authors", "Jackson", "Micrometer");
    }

    @Test
    void shouldHoldNoNativeLibrary() throws Exception {
        assertThat(JAR.names()).isNotEmpty().noneMatch(name -> name.matches(".*\\.(so|dll|jnilib|dylib)"));
        assertThat(JAR.manifest().getValue("Enable-Native-Access")).isNull();
    }

    @Test
    void shouldBeWhatJBangStarts() throws Exception {
        JsonNode aliases = new ObjectMapper()
                .readTree(Path.of("..", "..", ".jbang", "jbang-catalog.json").toFile())
                .get("aliases");
        String version = JAR.manifest().getValue(Attributes.Name.IMPLEMENTATION_VERSION);
        assertThat(aliases.at("/jsm/script-ref").asText())
                .isEqualTo("org.jsmesh:jsm-app:" + version + ":runnable@fatjar");
        assertThat(aliases.at("/jsm-viewer/script-ref").asText())
                .isEqualTo("org.jsmesh:jsm-desktop:" + version + ":runnable@fatjar");
    }

    @Test
    void shouldTellItsVersionAndNothingElse() throws Exception {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-jar",
                        JAR.path().toString(),
                        "--version")
                .redirectErrorStream(true)
                .start();
        try {
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
            assertThat(output.strip())
                    .isEqualTo("jsm " + JAR.manifest().getValue(Attributes.Name.IMPLEMENTATION_VERSION));
        } finally {
            process.destroyForcibly();
        }
    }
}
