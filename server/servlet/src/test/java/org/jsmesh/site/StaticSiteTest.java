package org.jsmesh.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jsmesh.test.LockProbe;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StaticSiteTest {
    private static final SortedMap<String, byte[]> PAGE = new TreeMap<>(Map.of("index.html", new byte[0]));

    @TempDir
    private Path folder;

    @Test
    void shouldStayLockedWhenASecondRunOfTheProcessIsRefused() throws Exception {
        Path lock = folder.resolve(".jsm-site.lock");
        try (StaticSite site = StaticSite.open(folder, PAGE)) {
            assertThat(site.staging()).doesNotExist();
            assertThatThrownBy(() -> StaticSite.open(folder, PAGE))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("another run");
            assertThat(LockProbe.isFree(lock)).isFalse();
        }
        assertThat(LockProbe.isFree(lock)).isTrue();
        StaticSite.open(folder, PAGE).close();
    }
}
