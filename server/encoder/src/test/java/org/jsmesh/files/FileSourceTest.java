package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileSourceTest {
    @TempDir
    private Path folder;

    @Test
    void shouldGiveTheBytesFromAnyPlace() throws Exception {
        Path file = Files.write(folder.resolve("a"), new byte[] {1, 2, 3});
        FileSource source = FileSource.of(file);
        assertThat(source.length()).isEqualTo(3);
        for (int i = 0; i <= 3; i++) {
            try (InputStream in = source.from(i)) {
                assertThat(in.readAllBytes()).hasSize(3 - i);
                assertThat(in.read()).isEqualTo(-1);
            }
        }
    }

    @Test
    void shouldRefuseAFileThatChangesWhileItIsRead() throws Exception {
        Path file = Files.write(folder.resolve("a"), new byte[1000]);
        FileSource source = FileSource.of(file);
        try (InputStream in = source.from(0)) {
            assertThat(in.readNBytes(500)).hasSize(500);
            Files.write(file, new byte[300], StandardOpenOption.TRUNCATE_EXISTING);
            assertThatThrownBy(in::readAllBytes)
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("was changed while it was read");
            assertThatThrownBy(in::read).isInstanceOf(FileSystemException.class);
        }
        assertThatThrownBy(() -> source.from(0)).isInstanceOf(FileSystemException.class);
    }
}
