package org.jsmesh.encoder;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFilesTest {
    @TempDir
    private Path folder;

    @Test
    void shouldMakeFoldersAndReplaceWhatIsThere() throws IOException {
        Path target = folder.resolve("a/b/x.jsm");
        AtomicFiles.write(target, new byte[] {1});
        AtomicFiles.write(target, new byte[] {2, 3});
        assertThat(target).hasBinaryContent(new byte[] {2, 3});
        assertThat(target.getParent()).isDirectoryContaining(target::equals);
        assertThat(files(target.getParent())).isEqualTo(1);
    }

    @Test
    void shouldLeaveNothingBehindWhenItFails() throws IOException {
        Path target = Files.createDirectories(folder.resolve("full/x.jsm").resolve("inside"))
                .getParent();
        assertThatThrownBy(() -> AtomicFiles.write(target, new byte[] {1})).isInstanceOf(IOException.class);
        assertThat(files(folder.resolve("full"))).isEqualTo(1);
    }

    private static long files(Path folder) throws IOException {
        try (var list = Files.list(folder)) {
            return list.count();
        }
    }
}
