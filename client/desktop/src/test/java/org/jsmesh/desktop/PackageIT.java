package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The application image that the profile {@code package} makes, with its own Java. */
class PackageIT {
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
    }
}
