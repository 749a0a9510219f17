package org.jsmesh.library;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.test.SampleModels;
import org.jsmesh.test.source.JavaProgram;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The examples in the overviews of the packages that modules export. They are compiled, not run. */
class PackageExamplesTest {
    private static final List<String> MODULES = List.of("core", "client/session", "server/encoder", "server/servlet");
    private static final Pattern EXAMPLE = Pattern.compile("(?s)<pre>\\{@code\\n(.*?)\\}</pre>");

    /** A class with what examples take as given. */
    private static final String CLASS = """
            import jakarta.servlet.ServletContext;
            import java.io.*;
            import java.net.*;
            import java.nio.file.*;
            import java.time.*;
            import java.util.*;
            import org.jsmesh.archive.*;
            import org.jsmesh.decode.*;
            import org.jsmesh.display.*;
            import org.jsmesh.encode.*;
            import org.jsmesh.files.*;
            import org.jsmesh.memory.*;
            import org.jsmesh.mesh.*;
            import org.jsmesh.mesh.io.*;
            import org.jsmesh.objects.ObjectStore;
            import org.jsmesh.objects.ObjectStores;
            import org.jsmesh.page.*;
            import org.jsmesh.plan.*;
            import org.jsmesh.poster.*;
            import org.jsmesh.servlet.*;
            import org.jsmesh.session.*;
            import org.jsmesh.simulation.*;
            import org.jsmesh.site.*;
            import org.jsmesh.sandbox.*;
            import org.jsmesh.secret.*;
            import org.jsmesh.store.*;
            import org.jsmesh.store.bucket.*;
            import org.jsmesh.upload.*;

            public abstract class Example {
                abstract double now();
                abstract Iterable<byte[]> fetch(long fromByte, long endByte) throws IOException;
                abstract void draw(DisplayMaterial material, int first, int count);

                @SuppressWarnings("try")
                void show(Mesh mesh, int baseFaces, int allFaces, ArchiveDecoder decoder, ServletContext application,
                        SortedMap<String, byte[]> page, byte[] bytes) throws Exception {
            %s}
            }
            """;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @MethodSource("overviews")
    void shouldCompile(Path overview) throws IOException {
        Matcher example = EXAMPLE.matcher(Files.readString(overview));
        assertThat(example.find()).as("there is an example").isTrue();
        String code = example.group(1).replaceAll("(?m)^ \\* ?", "").replaceAll("\\s+$", "\n");
        assertThat(code.lines().count()).isBetween(3L, 12L);
        assertThat(new JavaProgram("Example", CLASS.formatted(code)).compile(folder))
                .isEmpty();
    }

    @Test
    void shouldBeThePackagesThatTheLibraryPageNames() throws IOException {
        String page = Files.readString(SampleModels.project().resolve("docs/library.md"));
        for (String module : MODULES) {
            Matcher row = Pattern.compile("(?m)^\\| `jsm-\\w+` \\| `" + name(module) + "` \\| ([^|]+) \\|")
                    .matcher(page);
            assertThat(row.find()).as(module).isTrue();
            assertThat(row.group(1).replace("`", "").split(", ")).containsExactlyInAnyOrderElementsOf(exports(module));
        }
    }

    private static List<Path> overviews() throws IOException {
        List<Path> found = new ArrayList<>();
        for (String module : MODULES) {
            Path sources = SampleModels.project().resolve(module).resolve("src/main/java");
            for (String name : exports(module))
                found.add(sources.resolve(name.replace('.', '/') + "/package-info.java"));
        }
        return found;
    }

    /** The packages that everybody may use. */
    private static List<String> exports(String module) throws IOException {
        return Pattern.compile("exports ([\\w.]+);")
                .matcher(description(module))
                .results()
                .map(export -> export.group(1))
                .toList();
    }

    private static String name(String module) throws IOException {
        Matcher name = Pattern.compile("(?m)^module ([\\w.]+)").matcher(description(module));
        assertThat(name.find()).isTrue();
        return name.group(1);
    }

    private static String description(String module) throws IOException {
        return Files.readString(SampleModels.project().resolve(module).resolve("src/main/module/module-info.java"));
    }
}
