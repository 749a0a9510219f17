package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The application image that the profile {@code package} makes, with its own Java. */
class PackageIT {
    private static final String TRIANGLE = """
            {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
             "bufferViews": [{"buffer": 0, "byteLength": 36}],
             "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}
            """;

    @TempDir
    private Path folder;

    @Test
    void shouldDrawWithItsOwnJava() throws Exception {
        String made = System.getProperty("jsm.package");
        if (made == null) {
            System.out.println("SKIPPED PackageIT: there is no image; make one with -Ppackage");
            Assumptions.abort("no image");
        }
        Requirement.display();
        Path launcher = List.of(
                        "jsm-viewer/bin/jsm-viewer",
                        "jsm-viewer/jsm-viewer.exe",
                        "jsm-viewer.app/Contents/MacOS/jsm-viewer")
                .stream()
                .map(Path.of(made)::resolve)
                .filter(Files::isExecutable)
                .findFirst()
                .orElseThrow(() -> new AssertionError("no launcher in " + made));
        StartedViewer viewer = new StartedViewer(List.of(launcher.toString()), folder, Map.of("JAVA_HOME", "none"));
        viewer.assertDrawsTheTorus();
        assertThat(viewer.run(0, "--version")).startsWith("jsm-viewer 1.");
        // It encodes as well, which takes other parts of Java.
        Path model = Files.writeString(folder.resolve("triangle.gltf"), TRIANGLE);
        Path png = folder.resolve("triangle.png");
        assertThat(viewer.run(0, model.toString(), "--original", "--screenshot", png.toString()))
                .contains("1 of 1 faces");
        assertThat(ImageIO.read(png.toFile())).isNotNull();
    }
}
