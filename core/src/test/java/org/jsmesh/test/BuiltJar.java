package org.jsmesh.test;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.regex.Pattern;

/** A jar as the build made it, and what every jar that is published must hold. */
public record BuiltJar(Path path) {
    private static final Pattern LIBRARY = Pattern.compile("\"purl\" : \"pkg:maven/([^/\"]+)/([^@\"]+)@([^?\"]+)");
    /** {@code project.build.outputTimestamp} of the parent POM. */
    private static final LocalDateTime TIME = LocalDateTime.of(2026, 1, 1, 0, 0);

    /** Names of files and folders, in the order of the jar. */
    public List<String> names() throws IOException {
        try (JarFile jar = new JarFile(path.toFile())) {
            return jar.stream().map(entry -> entry.getName()).toList();
        }
    }

    public String text(String name) throws IOException {
        try (JarFile jar = new JarFile(path.toFile())) {
            assertThat(jar.getEntry(name)).as(name + " in " + path).isNotNull();
            return new String(jar.getInputStream(jar.getEntry(name)).readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    public Attributes manifest() throws IOException {
        try (JarFile jar = new JarFile(path.toFile())) {
            return jar.getManifest().getMainAttributes();
        }
    }

    /** Holds jSM's licence and its version, and classes that bear the time of every build. */
    public void assertPublishable(Path license) throws IOException {
        assertThat(text("META-INF/LICENSE")).as("licence in " + path).isEqualTo(Files.readString(license));
        assertThat(manifest().getValue(Attributes.Name.IMPLEMENTATION_TITLE))
                .as("title in " + path)
                .startsWith("jSM");
        assertThat(manifest().getValue(Attributes.Name.IMPLEMENTATION_VERSION))
                .as("version in " + path)
                .isNotNull();
        try (JarFile jar = new JarFile(path.toFile())) {
            assertThat(jar.stream().filter(entry -> entry.getName().matches("org/jsmesh/.*[^/]")))
                    .as("files in " + path)
                    .isNotEmpty()
                    .allSatisfy(entry ->
                            assertThat(entry.getTimeLocal()).as(entry.getName()).isEqualTo(TIME));
        }
    }

    /** Names every library of the bill of materials with its version, and brings the text of each licence. */
    public void assertNamesLibraries() throws IOException {
        String notices = text("META-INF/THIRD-PARTY.txt");
        List<String> libraries = libraries();
        assertThat(libraries).as("libraries in " + path).hasSizeGreaterThan(5);
        for (String library : libraries) {
            String line = notices.lines()
                    .filter(l -> l.startsWith("* " + library + ": "))
                    .findFirst()
                    .orElse("");
            assertThat(line)
                    .as(library + " in META-INF/THIRD-PARTY.txt of " + path)
                    .isNotEmpty();
            String licences = line.substring(library.length() + 4);
            if (licences.equals("Apache-2.0") || licences.startsWith("Apache-2.0, EPL-2.0")) continue;
            String group = library.substring(0, library.indexOf(':'));
            assertThat(notices)
                    .as("licence of " + library + ": add its text to .config/third-party")
                    .contains("\n---- " + group + ":");
        }
    }

    /** group:artifact:version of the works of others in the bill of materials. */
    private List<String> libraries() throws IOException {
        List<String> libraries = new ArrayList<>();
        LIBRARY.matcher(text("META-INF/sbom/application.cdx.json"))
                .results()
                .map(found -> found.group(1) + ":" + found.group(2) + ":" + found.group(3))
                .filter(library -> !library.startsWith("org.jsmesh:"))
                .distinct()
                .forEach(libraries::add);
        return libraries;
    }
}
