package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.jar.Attributes;
import javax.imageio.ImageIO;
import org.jsmesh.desktop.draw.Pictures;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.BuiltJar;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jar as users start it, with no native library unpacked before. */
class ViewerJarIT {
    private static final BuiltJar JAR = new BuiltJar(Path.of("target", "jsm-viewer.jar"));
    private static final Mesh ORIGINAL = Shapes.paintedTorus(60, 20);

    @TempDir
    private Path folder;

    @Test
    void shouldDrawTheOriginalIntoAFile() throws Exception {
        Requirement.display();
        Path model = folder.resolve("torus.jsm");
        Files.write(
                model,
                new MeshEncoder(EncoderSettings.defaults())
                        .encode(ORIGINAL, ProgressListener.NONE)
                        .bytes());
        Path png = folder.resolve("torus.png");
        String output = run(
                0,
                model.toString(),
                "--original",
                "--transparent",
                "--size",
                "320x240",
                "--screenshot",
                png.toString());
        assertThat(output).contains("torus.png: 2,400 of 2,400 faces").contains("identical to the original");
        BufferedImage picture = ImageIO.read(png.toFile());
        Pictures.assertAgree(picture, Pictures.expected(ORIGINAL, ORIGINAL.bounds()), 1);
        assertThat(unpackedLibraries()).isPositive();
    }

    @Test
    void shouldFailInOneLineWithoutAModel() throws Exception {
        Requirement.display();
        String output = run(
                1,
                folder.resolve("none.jsm").toString(),
                "--screenshot",
                folder.resolve("x.png").toString());
        assertThat(output.lines()).hasSize(1);
        assertThat(output).startsWith("jsm-viewer: ").contains("none.jsm", "does not exist");
        assertThat(folder.resolve("x.png")).doesNotExist();
    }

    @Test
    void shouldExplainWrongUsage() throws Exception {
        assertThat(run(2, "--wait", "soon", "x.jsm")).contains("'soon' is no time", "Usage: jsm-viewer");
        assertThat(run(2, "--screenshot", "x.png")).contains("--screenshot needs a model", "Usage: jsm-viewer");
    }

    @Test
    void shouldHoldLicenceVersionAndTheTimeOfEveryBuild() throws Exception {
        JAR.assertPublishable(Path.of("..", "..", "LICENSE"));
        assertThat(run(0, "--version").strip())
                .isEqualTo("jsm-viewer " + JAR.manifest().getValue(Attributes.Name.IMPLEMENTATION_VERSION));
    }

    @Test
    void shouldNameTheLibrariesInIt() throws Exception {
        JAR.assertNamesLibraries();
    }

    private String run(int expectedExit, String... arguments) throws IOException, InterruptedException {
        Path temporary = Files.createDirectories(folder.resolve("tmp"));
        Path log = folder.resolve("log.txt");
        List<String> command = new java.util.ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.io.tmpdir=" + temporary,
                "-jar",
                JAR.path().toString()));
        command.addAll(List.of(arguments));
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(log.toFile())
                .start();
        try {
            assertThat(process.waitFor(120, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        String output = Files.readString(log);
        assertThat(process.exitValue()).as(output).isEqualTo(expectedExit);
        return output;
    }

    private long unpackedLibraries() throws IOException {
        try (var files = Files.walk(folder.resolve("tmp"))) {
            return files.filter(f -> f.getFileName().toString().contains("jogl_desktop"))
                    .count();
        }
    }
}
