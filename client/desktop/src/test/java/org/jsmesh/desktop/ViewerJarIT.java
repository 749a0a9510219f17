package org.jsmesh.desktop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import org.jsmesh.test.BuiltJar;
import org.jsmesh.test.Requirement;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jar as users start it, with no native library unpacked before. */
class ViewerJarIT {
    private static final BuiltJar JAR = new BuiltJar(Path.of("target", "jsm-viewer.jar"));
    private static final Path SIGNED = Path.of("target", "signed", "jsm-viewer.jar");
    private static final String NATIVES = "natives/";

    @TempDir
    private Path folder;

    @Test
    void shouldDrawTheOriginalIntoAFile() throws Exception {
        Requirement.display();
        viewer(Path.of(System.getProperty("java.home"))).assertDrawsTheTorus();
        Set<String> unpacked = unpackedLibraries();
        assertThat(unpacked).anyMatch(name -> name.contains("jogl_desktop"));
        // Of one system alone.
        assertThat(natives().values()).as(unpacked.toString()).anyMatch(of -> of.containsAll(unpacked));
    }

    @Test
    void shouldDrawWithOtherJavas() throws Exception {
        Requirement.display();
        List<Path> homes = OtherJavas.homes();
        if (homes.isEmpty()) {
            System.out.println("SKIPPED ViewerJarIT: no other Java beside this one; name some by -Djsm.test.javas");
            Assumptions.abort("no other Java");
        }
        for (Path home : homes) viewer(home).assertDrawsTheTorus();
    }

    @Test
    void shouldHoldTheLibrariesOfEveryDesktopSystem() throws Exception {
        Map<String, Set<String>> natives = natives();
        assertThat(natives.keySet())
                .contains("linux-amd64", "linux-aarch64", "windows-amd64", "macosx-universal")
                .noneMatch(system -> system.startsWith("android"));
        assertThat(natives.values())
                .allSatisfy(names -> assertThat(names)
                        .anyMatch(name -> name.contains("jogl_desktop"))
                        .anyMatch(name -> name.contains("gluegen_rt")));
    }

    @Test
    void shouldBeSignedInACopy() throws Exception {
        try (JarFile plain = new JarFile(JAR.path().toFile());
                JarFile signed = new JarFile(SIGNED.toFile())) {
            for (var entry : plain.stream().toList()) {
                if (entry.isDirectory() || entry.getName().equals(JarFile.MANIFEST_NAME)) continue;
                var copy = signed.getJarEntry(entry.getName());
                assertThat(copy).as(entry.getName()).isNotNull();
                assertThat(signed.getInputStream(copy).readAllBytes())
                        .as(entry.getName())
                        .isEqualTo(plain.getInputStream(entry).readAllBytes());
                assertThat(copy.getCodeSigners()).as(entry.getName()).hasSize(1);
            }
        }
        Attributes manifest = new BuiltJar(SIGNED).manifest();
        assertThat(manifest.getValue("Permissions")).isEqualTo("all-permissions");
        assertThat(manifest.getValue("Codebase")).isEqualTo("*");
        assertThat(manifest.getValue("Application-Name")).isEqualTo("jSM viewer");
        assertThat(SIGNED.resolveSibling("made.p12")).doesNotExist();
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
    void shouldTakeNothingThatIsOpenedForAnOption() throws Exception {
        Requirement.display();
        String link = "jsm:file:///etc/passwd";
        assertThat(run(1, "--screenshot", folder.resolve("x.png").toString(), "--", link))
                .isEqualTo(run(1, "--screenshot", folder.resolve("x.png").toString(), link))
                .contains(link + " leads to no address of http or https");
        assertThat(run(1, "--screenshot", folder.resolve("x.png").toString(), "--", "--register"))
                .startsWith("jsm-viewer: --register: ");
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
        return viewer(Path.of(System.getProperty("java.home"))).run(expectedExit, arguments);
    }

    private StartedViewer viewer(Path home) throws IOException {
        Path temporary = Files.createDirectories(folder.resolve("tmp"));
        List<String> command = List.of(
                StartedViewer.java(home),
                "-Djava.io.tmpdir=" + temporary,
                "-jar",
                JAR.path().toString());
        return new StartedViewer(command, folder, Map.of());
    }

    /** Names of libraries by the system that they are for. */
    private static Map<String, Set<String>> natives() throws IOException {
        return JAR.names().stream()
                .filter(name -> name.matches(NATIVES + "[^/]+/[^/]+"))
                .map(name -> name.substring(NATIVES.length()))
                .collect(Collectors.groupingBy(
                        name -> name.substring(0, name.indexOf('/')),
                        Collectors.mapping(name -> name.substring(name.indexOf('/') + 1), Collectors.toSet())));
    }

    private Set<String> unpackedLibraries() throws IOException {
        try (var files = Files.walk(folder.resolve("tmp"))) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.matches(".*\\.(so|dll|jnilib|dylib)"))
                    .collect(Collectors.toCollection(TreeSet::new));
        }
    }
}
