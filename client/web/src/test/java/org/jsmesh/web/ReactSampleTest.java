package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jsmesh.test.Requirement;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.PageServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The sample for React, which Vite bundles with the npm package. */
class ReactSampleTest {
    private static final Path PACKAGE = Path.of(System.getProperty("jsm.npm.package"));
    private static final Path SAMPLE = Path.of("src/samples/react");
    private static final Path PACKAGES = Path.of("node_modules").toAbsolutePath();
    private static final String POLICY =
            "default-src 'self' blob: data:; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'";
    private static final Duration PATIENCE = Duration.ofMinutes(4);

    @TempDir
    Path folder;

    @Test
    void shouldDrawAModel() throws IOException, InterruptedException {
        Path site = bundle(Requirement.node());
        try (Browser browser = new Browser(folder.resolve("profile"));
                PageServer server = new PageServer(POLICY)) {
            for (Path file : filesBelow(site)) {
                server.put("/" + site.relativize(file).toString().replace('\\', '/'), Files.readAllBytes(file));
            }
            server.put("/model.jsm", DecodingSessionTest.archive("image.png"));
            browser.open(server.address("/index.html"));
            Instant end = Instant.now().plus(PATIENCE);
            while (coloursOf(browser.screenshot()) < 2 && Instant.now().isBefore(end)) Thread.sleep(200);
            assertThat(coloursOf(browser.screenshot())).isGreaterThan(1);
            assertThat(browser.consoleErrors()).isEmpty();
        }
    }

    /** The sample's folder, as it lies in a project that has installed the packages. */
    private Path bundle(Path node) throws IOException, InterruptedException {
        // Beside the packages, so that those are found.
        Path project = Files.createDirectories(Path.of("target/samples/react").toAbsolutePath());
        copy(SAMPLE, project);
        copy(PACKAGE, Files.createDirectories(project.resolve("node_modules/jsm-viewer")));
        Path site = folder.resolve("site");
        Path vite = PACKAGES.resolve("vite/bin/vite.js");
        Process build = new ProcessBuilder(node.toString(), vite.toString(), "build", "--outDir", site.toString())
                .directory(project.toFile())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("log").toFile())
                .start();
        build.getOutputStream().close();
        assertThat(build.waitFor(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isTrue();
        assertThat(build.exitValue())
                .as(Files.readString(folder.resolve("log")))
                .isZero();
        return site;
    }

    private static void copy(Path from, Path to) throws IOException {
        for (Path file : filesBelow(from)) {
            Path target = to.resolve(from.relativize(file).toString());
            Files.createDirectories(target.getParent());
            Files.write(target, Files.readAllBytes(file));
        }
    }

    private static List<Path> filesBelow(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).toList();
        }
    }

    private static long coloursOf(BufferedImage picture) {
        int[] pixels = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
        return Arrays.stream(pixels).distinct().count();
    }
}
