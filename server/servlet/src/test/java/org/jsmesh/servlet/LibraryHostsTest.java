package org.jsmesh.servlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import org.jsmesh.test.SampleModels;
import org.jsmesh.test.source.JavaProgram;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The programs of {@code docs/library.md} for the containers of this module. What they do is what the hosts test. */
class LibraryHostsTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"ServeByTomcat", "ModelsConfiguration"})
    void shouldCompile(String name) throws IOException {
        JavaProgram program = JavaProgram.in(SampleModels.project().resolve("docs/library.md"), name);
        assertThat(program.compile(folder)).isEmpty();
    }
}
