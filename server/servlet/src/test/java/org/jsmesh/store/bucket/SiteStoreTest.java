package org.jsmesh.store.bucket;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.jsmesh.objects.FolderObjectStore;
import org.jsmesh.store.ModelUnavailableException;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class SiteStoreTest {
    private static final String SHA256 = "a".repeat(64);

    @TempDir
    private Path folder;

    private FaultyStore objects;
    private SiteStore site;

    @BeforeEach
    void write() throws Exception {
        Files.createDirectories(folder.resolve("m/chair"));
        Files.writeString(
                folder.resolve("m/chair/manifest.json"),
                "{\"name\": \"The chair\", \"archiveUrl\": \"" + SHA256 + ".jsm\"}");
        TestSites.list(folder, "chair");
        objects = new FaultyStore(new FolderObjectStore(folder));
    }

    private void open(SiteSettings settings, long readMillis) throws Exception {
        site = TestSites.open(objects, settings, readMillis);
    }

    @AfterEach
    void stop() throws Exception {
        site.close();
        objects.close();
    }

    /** Those who hung go on to hang, as connections do whose other end has gone. */
    @Test
    void shouldGoOnWhenAStoreIsWellAgainThatHung() throws Exception {
        open(SiteSettings.defaults(), 500);
        objects.hang();
        List<CompletableFuture<SiteModel>> asked = new ArrayList<>();
        for (int i = 0; i < 40; i++) asked.add(site.model("other-" + i));
        for (CompletableFuture<SiteModel> one : asked)
            assertThatThrownBy(one::join).hasMessageContaining("did not answer within 500 ms");
        objects.recover();
        // A busy machine may need more than one try.
        Await.until(
                "a model",
                () -> site.model("chair")
                        .handle((model, failure) -> failure == null)
                        .join());
    }

    @Test
    void shouldHaveNoModelOfAnIdThatNoneCanHave() throws Exception {
        open(SiteSettings.defaults(), 30_000);
        for (String id : List.of("x".repeat(2000), "..", "a//b")) {
            assertThat(site.archive(id, SHA256).join()).isNull();
            assertThat(site.annotations(id).join()).isNull();
            assertThatThrownBy(() -> site.model(id).join())
                    .cause()
                    .isInstanceOfSatisfying(
                            ModelUnavailableException.class,
                            failure -> assertThat(failure.isGone()).isTrue());
        }
        assertThat(site.failedReads()).isZero();
    }

    @Test
    void shouldTellThatItMayTakeTimeToSignAddresses() throws Exception {
        open(SiteSettings.defaults(), 30_000);
        assertThat(site.isKnown("chair")).isTrue();
        site.close();
        open(SiteSettings.defaults().withRedirect(Duration.ofSeconds(90)), 30_000);
        assertThat(site.isKnown("chair")).isFalse();
    }
}
