package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.jsmesh.desktop.draw.Pictures;
import org.jsmesh.desktop.draw.Shapes;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.ProgressListener;

/** The viewer as a process of its own, as users start it. */
public final class StartedViewer {
    private static final Mesh ORIGINAL = Shapes.paintedTorus(60, 20);
    private static final int SECONDS = 120;

    private final List<String> command;
    private final Path folder;
    private final Map<String, String> environment;

    /**
     * @param command that starts it without arguments
     * @param folder for its output
     * @param environment in addition to that of the test
     */
    public StartedViewer(List<String> command, Path folder, Map<String, String> environment) {
        this.command = command;
        this.folder = folder;
        this.environment = environment;
    }

    /** By this Java. */
    public static String java() {
        return java(Path.of(System.getProperty("java.home")));
    }

    static String java(Path home) {
        return home.resolve("bin").resolve("java").toString();
    }

    /** An archive of a small model of many colours. */
    public static Path torus(Path folder) throws IOException {
        byte[] archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(ORIGINAL, ProgressListener.NONE)
                .bytes();
        return Files.write(folder.resolve("torus.jsm"), archive);
    }

    /** Has it draw the torus into a file, and compares that with how it must look. */
    public void assertDrawsTheTorus() throws IOException, InterruptedException {
        Path png = folder.resolve("torus.png");
        String output = run(
                0,
                torus(folder).toString(),
                "--original",
                "--transparent",
                "--size",
                "320x240",
                "--screenshot",
                png.toString());
        assertThat(output).contains("torus.png: 2,400 of 2,400 faces").contains("identical to the original");
        assertShowsTheTorus(png);
    }

    /** @param png of 320 by 240 pixels without background, of the original */
    public static void assertShowsTheTorus(Path png) throws IOException {
        BufferedImage picture = ImageIO.read(png.toFile());
        Pictures.assertAgree(picture, Pictures.expected(ORIGINAL, ORIGINAL.bounds()), 1);
    }

    /** Runs it to its end; gives what it printed. */
    public String run(int expectedExit, String... arguments) throws IOException, InterruptedException {
        Path log = folder.resolve("log.txt");
        List<String> whole = new ArrayList<>(command);
        whole.addAll(List.of(arguments));
        ProcessBuilder builder =
                new ProcessBuilder(whole).redirectErrorStream(true).redirectOutput(log.toFile());
        builder.environment().putAll(environment);
        Process process = builder.start();
        try {
            assertThat(process.waitFor(SECONDS, TimeUnit.SECONDS)).isTrue();
        } finally {
            process.destroyForcibly();
        }
        String output = Files.readString(log);
        assertThat(process.exitValue()).as(output).isEqualTo(expectedExit);
        return output;
    }
}
