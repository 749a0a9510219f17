package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
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

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void shouldReplaceNothingButRegularFiles() throws Exception {
        Path pipe = folder.resolve("pipe");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        Path link = Files.createSymbolicLink(folder.resolve("link"), pipe);
        Path lost = Files.createSymbolicLink(folder.resolve("lost"), folder.resolve("nowhere"));
        for (Path target : new Path[] {pipe, link, lost})
            assertThatThrownBy(() -> AtomicFiles.write(target, new byte[] {1}))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining(target.toString())
                    .hasMessageContaining("no regular file");
        assertThat(Files.exists(pipe)).isTrue();
        assertThat(Files.isRegularFile(pipe)).isFalse();
        assertThat(link).isSymbolicLink();
        assertThat(lost).isSymbolicLink();
    }

    @Test
    void shouldWriteThroughALinkToAFile() throws IOException {
        Path file = Files.write(folder.resolve("file"), new byte[] {1});
        Path link = Files.createSymbolicLink(folder.resolve("link"), file);
        AtomicFiles.write(link, new byte[] {2});
        assertThat(link).isSymbolicLink();
        assertThat(file).hasBinaryContent(new byte[] {2});
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void shouldNameTheTargetThatCannotBeWritten() {
        assertThatThrownBy(() -> AtomicFiles.write(Path.of("/proc/x.jsm"), new byte[] {1}))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining("/proc/x.jsm: cannot be written")
                .hasMessageNotContaining(".part");
    }

    @Test
    void shouldGiveAWholeFileItsNameInAnotherFolder() throws IOException {
        Path from = Files.write(folder.resolve("part"), new byte[] {1, 2});
        Path to = Files.write(Files.createDirectory(folder.resolve("place")).resolve("x.jsm"), new byte[] {3});
        AtomicFiles.move(from, to);
        assertThat(from).doesNotExist();
        assertThat(to).hasBinaryContent(new byte[] {1, 2});
        assertThatThrownBy(() -> AtomicFiles.move(from, to)).isInstanceOf(NoSuchFileException.class);
        assertThat(to).hasBinaryContent(new byte[] {1, 2});
    }

    /** A file's new name is worth more than certainty that it outlives a power cut. */
    @Test
    void shouldNotFailWhereNamesCannotBeForced() {
        assertThatCode(() -> AtomicFiles.syncFolder(folder.resolve("gone"))).doesNotThrowAnyException();
    }

    private static long files(Path folder) throws IOException {
        try (var list = Files.list(folder)) {
            return list.count();
        }
    }
}
