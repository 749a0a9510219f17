package org.jsmesh.lock;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.jsmesh.test.LockProbe;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LockedFileTest {
    @TempDir
    private Path folder;

    @Test
    void shouldBelongToOneAtATime() throws Exception {
        Path file = folder.resolve("lock");
        LockedFile first = LockedFile.tryLock(file);
        assertThat(first).isNotNull();
        assertThat(LockedFile.tryLock(file)).isNull();
        // What was refused must not have freed what other processes ask for.
        assertThat(LockProbe.isFree(file)).isFalse();
        first.close();
        assertThat(LockProbe.isFree(file)).isTrue();
        LockedFile.tryLock(file).close();
    }

    @Test
    void shouldBeOneFileByAnyPath() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("link"), Files.createDirectory(folder.resolve("real")));
        try (LockedFile first = LockedFile.tryLock(link.resolve("lock"))) {
            assertThat(first).isNotNull();
            assertThat(LockedFile.tryLock(folder.resolve("real/../real/lock"))).isNull();
        }
    }

    @Test
    void shouldNotFreeWhatAnotherHasWhenItIsClosedTwice() throws IOException {
        Path file = folder.resolve("lock");
        LockedFile first = LockedFile.tryLock(file);
        first.close();
        try (LockedFile second = LockedFile.tryLock(file)) {
            first.close();
            assertThat(second).isNotNull();
            assertThat(LockedFile.tryLock(file)).isNull();
        }
    }

    @Test
    void shouldYieldToWhoLockedTheFileInAnotherWay() throws IOException {
        Path file = folder.resolve("lock");
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
                FileLock lock = channel.lock()) {
            assertThat(lock.isValid()).isTrue();
            assertThat(LockedFile.tryLock(file)).isNull();
        }
        LockedFile.tryLock(file).close();
    }

    @Test
    void shouldSayThatTheFolderIsMissingAndHoldNothing() throws IOException {
        Path file = folder.resolve("gone/lock");
        assertThatThrownBy(() -> LockedFile.tryLock(file)).isInstanceOf(IOException.class);
        Files.createDirectory(file.getParent());
        LockedFile.tryLock(file).close();
    }
}
