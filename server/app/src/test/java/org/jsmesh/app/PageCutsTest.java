package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.session.testing.ProxiedExchange;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Connections that end at every kind of byte under the page, and pages that are left in the middle. */
@Tag("long")
class PageCutsTest extends PageFixture {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "request sent",
                "headers",
                "first byte",
                "header of the archive",
                "base",
                "border of base and batch",
                "middle of a batch",
                "border of a batch",
                "last byte"
            })
    void shouldGoOnWithTheByteWhereTheConnectionEnded(String place) throws Exception {
        BatchIndex index = ArchiveFile.of(archive).header().batches();
        int middle = index.size() / 2;
        switch (place) {
            case "request sent" -> proxy.cutHeadAfter(0);
            case "headers" -> proxy.cutHeadAfter(30);
            case "first byte" -> proxy.cutAfter(1);
            case "header of the archive" -> proxy.cutAfter(40);
            case "base" -> proxy.cutAfter(index.end(0) - 20);
            case "border of base and batch" -> proxy.cutAfter(index.end(0));
            case "middle of a batch" -> proxy.cutAfter(index.offset(middle) + index.bytes(middle) / 2);
            case "border of a batch" -> proxy.cutAfter(index.end(middle));
            default -> proxy.cutAfter(archive.length - 1);
        }
        openArchive();
        browser.await("jsm.state === 'idle' || jsm.state === 'complete' || jsm.state === 'error'");
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThatEveryByteWasSentOnce();
    }

    /** On the wire: a byte that came before a break may reach the page through the browser's own cache. */
    private void assertThatEveryByteWasSentOnce() {
        List<ProxiedExchange> bodies = new ArrayList<>(archiveExchanges());
        bodies.removeIf(e -> e.bodyBytes() == 0);
        bodies.sort(Comparator.comparingLong(ProxiedExchange::fromByte));
        long at = 0;
        for (ProxiedExchange e : bodies) {
            assertThat(e.fromByte()).as(e.toString()).isEqualTo(at);
            at += e.bodyBytes();
        }
        assertThat(at).isEqualTo(archive.length);
    }

    @Test
    void shouldLoseLittleWhenThePageIsLeftInTheMiddle() {
        proxy.bytesPerSecond(LINK / 2);
        open("m=torus");
        browser.await("window.jsm?.bytes > 20000");
        // The page goes while the link is slow: on a fast one it would have everything before it is left.
        browser.open(URI.create("about:blank"));
        int before = archiveExchanges().size();
        browser.forget();
        proxy.bytesPerSecond(FAST);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        // What came in the last moments may not have been written.
        long kept = (long) number("jsm.keptBytes");
        assertThat(kept).isPositive();
        assertThat(archiveExchanges().subList(before, archiveExchanges().size()))
                .anyMatch(e -> e.fromByte() >= kept) // what lies between came from the browser's own cache
                .noneMatch(e -> e.fromByte() == 0);
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
    }
}
