package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.module.ModuleDescriptor;
import java.lang.module.ModuleFinder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jsmesh.test.BuiltJar;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the modules that this one is made of give to Maven Central. */
class PublishedModulesIT {
    private static final Path ROOT = Path.of("..", "..");
    private static final Pattern MODULE = Pattern.compile("<module>([^<]+)</module>");
    private static final Pattern EXPORTED = Pattern.compile("<exported\\.packages>([^<]+)</exported\\.packages>");

    @TempDir
    Path folder;

    /** Of the parent POM, those that are built before this one. */
    static List<String> modules() throws IOException {
        return MODULE.matcher(Files.readString(ROOT.resolve("pom.xml")))
                .results()
                .map(found -> found.group(1))
                .filter(module -> !module.equals("client/desktop") && !module.equals("server/spark"))
                .toList();
    }

    @Test
    void shouldKnowTheModules() throws IOException {
        assertThat(modules()).contains("core", "server/app");
    }

    @ParameterizedTest
    @MethodSource("modules")
    void shouldHoldLicenceVersionAndTheTimeOfEveryBuild(String module) throws IOException {
        new BuiltJar(jar(module, "")).assertPublishable(ROOT.resolve("LICENSE"));
    }

    @ParameterizedTest
    @MethodSource("modules")
    void shouldComeWithTheirSources(String module) throws IOException {
        Path sources = ROOT.resolve(module).resolve("src/main/java");
        try (Stream<Path> files = Files.walk(sources)) {
            List<String> names = files.filter(file -> file.toString().endsWith(".java"))
                    .map(file -> sources.relativize(file).toString().replace('\\', '/'))
                    .toList();
            assertThat(new BuiltJar(jar(module, "-sources")).names()).containsAll(names);
        }
    }

    /** The compiler says nothing of a package in its list that does not exist, nor of one that is missing there. */
    @ParameterizedTest
    @MethodSource("modules")
    void shouldCheckTheJavadocOfWhatTheyExport(String module) throws IOException {
        Matcher property =
                EXPORTED.matcher(Files.readString(ROOT.resolve(module).resolve("pom.xml")));
        List<String> checked = property.find() ? List.of(property.group(1).split(",")) : List.of();
        BuiltJar jar = new BuiltJar(jar(module, ""));
        List<String> names = jar.names();
        assertThat(checked)
                .allSatisfy(name -> assertThat(names).contains(name.replace('.', '/') + "/package-info.class"));
        if (!names.contains("module-info.class")) return;
        assertThat(checked).containsExactlyInAnyOrderElementsOf(exported(jar));
    }

    private List<String> exported(BuiltJar jar) throws IOException {
        Path alone = Files.copy(jar.path(), folder.resolve("alone.jar"));
        Optional<ModuleDescriptor> module = ModuleFinder.of(alone).findAll().stream()
                .map(reference -> reference.descriptor())
                .findFirst();
        return module.orElseThrow().exports().stream()
                .filter(export -> !export.isQualified())
                .map(ModuleDescriptor.Exports::source)
                .toList();
    }

    private static Path jar(String module, String kind) throws IOException {
        Path target = ROOT.resolve(module).resolve("target");
        Pattern name = Pattern.compile("jsm-[a-z0-9]+-[0-9][0-9.]*(-SNAPSHOT)?" + kind + "\\.jar");
        try (Stream<Path> files = Files.list(target)) {
            return files.filter(
                            file -> name.matcher(file.getFileName().toString()).matches())
                    .findFirst()
                    .orElseThrow(
                            () -> new AssertionError("no jar " + kind + " in " + target + "; run mvn verify there"));
        }
    }
}
