package org.jsmesh.webapp;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Containers and Spring Boot send {@code META-INF/resources} of every jar, an {@code index.html} in it as the front
 * page of the host.
 */
class FrontPageTest {
    private static final String RESOURCES = "META-INF/resources";

    @Test
    void shouldReplaceNoFrontPage() throws Exception {
        assertThat(FrontPageTest.class.getClassLoader().getResource(RESOURCES + "/jsm/index.html"))
                .isNotNull();
        assertThat(FrontPageTest.class.getClassLoader().getResource(RESOURCES + "/index.html"))
                .isNull();
    }

    @Test
    void shouldKeepEverythingInAFolderOfItsOwn() throws Exception {
        Path place = Path.of(FrontPageTest.class
                .getClassLoader()
                .getResource(RESOURCES + "/jsm/index.html")
                .toURI()
                .getSchemeSpecificPart()
                .replaceFirst("^file:", "")
                .replaceFirst("!?/META-INF/.*$", ""));
        if (Files.isDirectory(place)) {
            assertThat(names(place.resolve(RESOURCES))).containsExactly("jsm");
            return;
        }
        try (FileSystem jar = FileSystems.newFileSystem(place, Map.of())) {
            assertThat(names(jar.getPath(RESOURCES))).containsExactly("jsm");
        }
    }

    private static List<String> names(Path folder) throws Exception {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString().replace("/", ""))
                    .toList();
        }
    }
}
