package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AnnotationFileTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"Big chair.obj", "Big chair.jsm", "Big chair.ply.gz"})
    void shouldStandBesideTheModel(String model) throws IOException {
        assertThat(AnnotationFile.beside(folder.resolve(model))).isNull();
        Path file = Files.writeString(folder.resolve("Big chair.annotations.json"), "{\"annotations\": []}");
        assertThat(AnnotationFile.beside(folder.resolve(model))).isEqualTo(file);
        assertThat(AnnotationFile.read(file)).asString().isEqualTo("{\"annotations\": []}");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {"{\"annotations\": [}|not JSON in line 1", "[]|no list", "{}|no list", "''|no list", "7|no list"})
    void shouldSayWhatIsWrong(String content, String reason) throws IOException {
        Path file = Files.writeString(folder.resolve("a.annotations.json"), content);
        assertThatThrownBy(() -> AnnotationFile.read(file))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining(reason);
    }

    @Test
    void shouldRefuseALargeFile() throws IOException {
        Path file = Files.write(folder.resolve("a.annotations.json"), new byte[AnnotationFile.MOST_BYTES + 1]);
        assertThatThrownBy(() -> AnnotationFile.read(file)).hasMessageContaining("is larger than 1048576 bytes");
    }
}
