package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RightsTest {
    @TempDir
    private Path folder;

    @Test
    void shouldTryToReadAFileOfEveryStore() throws IOException {
        CatalogueSettings settings =
                Cluster.settings("in", folder.resolve("site").toString());
        Files.createDirectories(folder.resolve("site-report"));
        Files.writeString(folder.resolve("site-report/jsm-trial-run"), "");
        Files.writeString(folder.resolve("a.ply"), "ply");
        ListedModel here = new ListedModel(folder.toString(), "a.ply", "a.ply", 3, "", Instant.EPOCH);
        // Of a list nothing is known but the address.
        ListedModel there = new ListedModel("what://else", "a.ply", "a.ply", -1, "", Instant.EPOCH);
        assertThat(Rights.trial(settings, "run", List.of(), 0)).isEmpty();
        // Another run has its own.
        assertThat(Rights.trial(settings, "other", List.of(), 0)).contains("is another folder");
        assertThat(Rights.trial(settings, "run", List.of(here, there), 0)).contains("what://else");
    }

    @Test
    void shouldNoticeAReportInAnotherFolder() {
        CatalogueSettings settings =
                Cluster.settings("in", folder.resolve("site").toString());
        assertThat(Rights.trial(settings, "run", List.of(), 0)).contains("is another folder on other machines");
    }
}
