package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.Headers;
import java.io.IOException;
import java.net.URI;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jsmesh.session.testing.StaticFileServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The page when the link, the server or the archive fails. */
class PageTroubleTest extends PageFixture {
    @Test
    void shouldWaitForTheBaseBeyondTheEndOfTheRound() throws IOException {
        proxy.bytesPerSecond(300);
        openArchive();
        browser.await("window.jsm?.bytes > 0 && document.getElementById('wait-text').textContent.includes('received')");
        assertThat(text("jsm.state")).isEqualTo("loading");
        browser.await("performance.now() - jsm.rounds[0].at > 3000");
        assertThat(text("jsm.state")).isEqualTo("loading");
        proxy.bytesPerSecond(4000);
        browser.await("jsm.state !== 'loading' && jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(number("jsm.rounds.length")).isEqualTo(1);
        assertThat(number("jsm.firstPicture.millis - jsm.rounds[0].at")).isGreaterThan(2000);
        assertThatPictureAgrees("late-base");
    }

    @Test
    void shouldWaitForAFirstByteThatComesAfterTheRound() {
        proxy.delayMillis(2500);
        openArchive();
        browser.await("jsm.state !== 'loading' && jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(number("jsm.faces")).isGreaterThan(0);
    }

    @Test
    void shouldSayThatAnArchiveCannotBeFetchedAndTryAgain() throws IOException {
        int port = proxy.port();
        proxy.close();
        openArchive();
        browser.await(
                "window.jsm?.state === 'loading' && document.getElementById('wait-text').textContent.includes('trying again')");
        browser.await("jsm.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("127.0.0.1:" + port + "/", "cannot be fetched");
        assertThat(browser.isShown("#wait")).isFalse();
        browser.click("#retry");
        browser.await("jsm.state === 'loading'");
        browser.await("jsm.state === 'error'");
    }

    @Test
    void shouldLeaveABusyServerAloneForAsLongAsItSays() throws IOException {
        AtomicReference<String> busy = new AtomicReference<>("600");
        AtomicInteger refusals = new AtomicInteger();
        try (StaticFileServer host = StaticFileServer.withoutRanges()) {
            URI address = host.handle("/full.jsm", exchange -> {
                try (exchange) {
                    Headers headers = exchange.getResponseHeaders();
                    headers.set("Access-Control-Allow-Origin", "*");
                    headers.set("Access-Control-Expose-Headers", "Retry-After");
                    if (busy.get() != null) {
                        refusals.incrementAndGet();
                        headers.set("Retry-After", busy.get());
                        exchange.sendResponseHeaders(503, -1);
                    } else {
                        exchange.sendResponseHeaders(200, archive.length);
                        exchange.getResponseBody().write(archive);
                    }
                }
            });
            browser.open(server.uri().resolve("?shading=matte&archive=" + address));
            browser.await(
                    "document.getElementById('wait-text').textContent.includes('The server is busy; trying again in 30 s (1 of 5)')");
            browser.call("jsm.stop();");
            browser.await("jsm.state === 'error'");
            assertThat(refusals).hasValue(1);
            busy.set("1");
            browser.click("#retry");
            browser.await("document.getElementById('wait-text').textContent.includes('trying again in 1 s (1 of 5)')");
            busy.set(null);
            browser.await("jsm.state === 'idle' || jsm.state === 'complete'");
            assertThat(number("jsm.faces")).isGreaterThan(0);
        }
    }

    @Test
    void shouldAskABusyServerForJsonAgain() {
        Object told = browser.call("const { fetchJson } = await import('/viewer/manifest.js');"
                + "const ask = fetch; const told = [];"
                + "const busy = () => new Response('{\"error\":\"full\"}', { status: 503, headers: { 'Retry-After': '1' } });"
                + "window.fetch = async () => told.length < 1 ? busy() : Response.json({ models: 7 });"
                + "try { told.push((await fetchJson('/x', 'default', text => told.push(text))).models); } finally { window.fetch = ask; }"
                + "return told.join(' ');");
        assertThat(told).isEqualTo("The server is busy; trying again in 1 s (1 of 5) 7");
    }

    @Test
    void shouldSayThatAnAddressIsNone() {
        browser.open(server.uri().resolve("?archive=//x:99999/"));
        browser.await("window.jsm?.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("\"//x:99999/\"", "not the address of an archive");
        assertThat(browser.isShown("#retry")).isFalse();
    }

    @Test
    void shouldSayWhichDecoderCannotBeLoaded() {
        proxy.refuse("/decoder.wasm");
        open("m=torus&decoder=wasm");
        browser.await("window.jsm?.state === 'error'");
        // The round that was wished meanwhile ends, too, and must not hide the reason.
        browser.call("await jsm.refine();");
        assertThat(browser.text("#alert-text"))
                .contains("The decoder could not be loaded", "decoder.wasm: HTTP status 500");
        assertThat(browser.isShown("#retry")).isFalse();
    }

    @Test
    void shouldDecodeWithJavaScriptWhereWebAssemblyCannotBeLoaded() {
        proxy.refuse("/decoder.wasm");
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        assertThat(text("jsm.decoder")).isEqualTo("js");
    }

    @Test
    void shouldReadOnByRangesWhenTheConnectionBreaksThatTheServerPlanned() {
        proxy.bytesPerSecond(MEGABIT / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        awaitSilence();
        browser.call("document.getElementById('server-plan').click();");
        browser.call("await jsm.refine();"); // makes whole the batch that was cut
        awaitSilence();
        proxy.cutAfter(10_000);
        browser.call("await jsm.refine();");
        awaitSilence();
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(number("jsm.rounds.length")).isEqualTo(3);
        String resumed =
                "jsm.requests.some((r, i, all) => all[i - 1]?.url.includes('/patches?') && all[i - 1].bytes > 0"
                        + " && r.from === all.slice(0, i).reduce((sum, other) => sum + other.bytes, 0) && r.bytes > 0)";
        assertThat(browser.call("return " + resumed + ";")).isEqualTo(true);
        proxy.bytesPerSecond(FAST);
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(number("jsm.requests.reduce((sum, r) => sum + r.bytes, 0)")).isEqualTo(archive.length);
    }

    @Test
    void shouldReadAnAnswerThatBeginsAfterTheRoundToItsEnd() {
        proxy.bytesPerSecond(MEGABIT / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.delayMillis(2500);
        browser.call("await jsm.refine();");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(number("jsm.rounds.at(-1).plans.length")).isLessThanOrEqualTo(1);
        browser.await(
                "jsm.requests.at(-1).from > 0 && jsm.requests.at(-1).bytes === jsm.requests.at(-1).end - jsm.requests.at(-1).from");
        assertThat(number("jsm.requests.at(-1).bytes"))
                .isEqualTo(number("jsm.requests.at(-1).end - jsm.requests.at(-1).from"));
        assertThatEveryByteCameOnce();
    }

    @Test
    void shouldSayThatTheServerIsSilentAndTryAgain() {
        proxy.bytesPerSecond(MEGABIT / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.delayMillis(60_000);
        browser.click("#more");
        browser.await("jsm.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("The server is silent", "10 s");
        proxy.delayMillis(0);
        double bytes = number("jsm.bytes");
        browser.click("#retry");
        browser.await("jsm.state === 'idle' || jsm.state === 'complete'");
        assertThat(number("jsm.bytes")).isGreaterThan(bytes);
    }

    @Test
    void shouldResumeAtTheByteWhereTheConnectionBroke() {
        proxy.bytesPerSecond(MEGABIT / 2);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.bytesPerSecond(4 * MEGABIT).cutAfter(54_321);
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(archiveExchanges()).anyMatch(e -> e.ifRange() != null);
        assertThatEveryByteCameOnce();
    }

    @Test
    void shouldReportADamagedArchiveAndNeverCallItIdentical() {
        proxy.bytesPerSecond(MEGABIT / 2);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        double faces = number("jsm.faces");
        proxy.bytesPerSecond(FAST).corruptByte(archive.length - 1000L);
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(text("jsm.state")).isEqualTo("error");
        assertThat(browser.text("#alert-text")).contains("The archive is damaged");
        assertThat(browser.isShown("#retry")).isFalse();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(false);
        assertThat(browser.isShown("#proof")).isFalse();
        assertThat(number("jsm.faces")).isGreaterThanOrEqualTo(faces);
    }

    @ParameterizedTest
    @ValueSource(strings = {"#original", "#more"})
    void shouldSayInWordsThatTheServerIsGone(String button) throws IOException {
        proxy.bytesPerSecond(MEGABIT / 2);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.close();
        browser.click(button);
        browser.await("document.getElementById('wait-text').textContent.includes('trying again (5 of 5)')");
        browser.await("jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("error");
        assertThat(browser.text("#alert-text")).contains("did not come back");
        assertThat(browser.isShown("#retry")).isTrue();
    }
}
