package org.jsmesh.session.cache;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.jsmesh.test.LockProbe;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Who may write an entry. */
class DiskCacheTest {
    private static final URI ADDRESS = URI.create("http://127.0.0.1/m/x/a.jsm");

    @TempDir
    private Path folder;

    private Path lock() throws Exception {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(f -> f.toString().endsWith(".lock") && !f.endsWith("cache.lock"))
                    .findFirst()
                    .orElseThrow();
        }
    }

    @Test
    void shouldStayLockedWhenAnotherSessionOfTheProcessAsksForTheEntry() throws Exception {
        DiskCache cache = new DiskCache(folder, 1000);
        try (KeptArchive first = cache.open(ADDRESS, "a")) {
            first.append(new byte[10], 0, 10);
            try (KeptArchive second = cache.open(ADDRESS, "a")) {
                second.append(new byte[20], 0, 20);
            }
            assertThat(LockProbe.isFree(lock())).isFalse();
            first.append(new byte[10], 0, 10);
        }
        assertThat(LockProbe.isFree(lock())).isTrue();
        Path data = lock().resolveSibling(lock().getFileName().toString().replace(".lock", ".jsm"));
        assertThat(data).hasSize(20);
    }

    @Test
    void shouldStayLockedWhenOldEntriesAreDropped() throws Exception {
        try (KeptArchive first = new DiskCache(folder, 1000).open(ADDRESS, "a")) {
            first.append(new byte[500], 0, 500);
            Path held = lock();
            new DiskCache(folder, 100).open(ADDRESS, "b").close();
            assertThat(held).exists();
            assertThat(LockProbe.isFree(held)).isFalse();
        }
    }
}
