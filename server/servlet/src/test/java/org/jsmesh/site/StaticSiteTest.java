package org.jsmesh.site;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
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

    @Test
    void shouldKeepFilesOfThePageBeforeForADay() throws Exception {
        publish("viewer/app-AAAAAAAA.js");
        publish("viewer/app-BBBBBBBB.js");
        assertThat(folder.resolve("viewer/app-AAAAAAAA.js")).exists();
        publish("viewer/app-BBBBBBBB.js");
        assertThat(folder.resolve("viewer/app-AAAAAAAA.js")).exists();
        Instant longAgo = Instant.now().minus(Duration.ofHours(25));
        Files.setLastModifiedTime(folder.resolve("index.html"), FileTime.from(longAgo));
        publish("viewer/app-BBBBBBBB.js");
        assertThat(folder.resolve("viewer/app-AAAAAAAA.js")).doesNotExist();
        assertThat(folder.resolve("viewer/app-BBBBBBBB.js")).exists();
    }

    @Test
    void shouldKnowItsOwnPageByWhatThatSaysOfItself() throws Exception {
        for (String own : List.of(
                "<meta name=\"generator\" content=\"jSM\">", "<script type=\"module\" src=\"viewer/page/app.js\">")) {
            Files.writeString(folder.resolve("index.html"), own);
            StaticSite.open(folder, PAGE).close();
        }
        Files.writeString(folder.resolve("index.html"), "<meta name=\"generator\" content=\"other\">");
        assertThatThrownBy(() -> StaticSite.open(folder, PAGE)).hasMessageContaining("another site");
    }

    private void publish(String script) throws IOException {
        String head = "<head><meta charset=\"utf-8\"><meta name=\"description\" content=\"\">"
                + "<meta name=\"generator\" content=\"jSM\"><title>jSM</title></head>";
        String body = "<body><noscript></noscript><script src=\"" + script + "\"></script></body>";
        byte[] index = (head + body).getBytes(UTF_8);
        Map<String, byte[]> page = Map.of("index.html", index, script, new byte[1]);
        try (StaticSite site = StaticSite.open(folder, new TreeMap<>(page))) {
            site.finish();
        }
    }
}
