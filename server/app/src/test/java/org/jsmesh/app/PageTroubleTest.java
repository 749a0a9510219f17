package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.Headers;
import java.io.IOException;
import java.net.URI;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.session.testing.StaticFileServer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The page when the link, the server or the archive fails. */
class PageTroubleTest extends PageFixture {
    @Test
    void shouldWaitForTheBaseBeyondTheEndOfTheRound() throws IOException {
        proxy.bytesPerSecond(150);
        openArchive();
        browser.await("window.jsm?.bytes > 0 && document.getElementById('wait-text').textContent.includes('received')");
        assertThat(text("jsm.state")).isEqualTo("loading");
        browser.await("performance.now() - jsm.rounds[0].at > 3000");
        assertThat(text("jsm.state")).isEqualTo("loading");
        proxy.bytesPerSecond(2000);
        browser.await("jsm.state !== 'loading' && jsm.state !== 'refining'");
        assertThat(text("jsm.state")).isEqualTo("idle");
        assertThat(number("jsm.rounds.length")).isEqualTo(1);
        assertThat(number("jsm.firstPicture.millis - jsm.rounds[0].at")).isGreaterThan(2000);
        awaitSilence();
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
        Object told = browser.call("const { fetchJson } = await import('/modules/session/manifest.js');"
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
    void shouldSayWhichDecoderCannotBeLoaded() throws IOException {
        connectWithNothingKept();
        proxy.refuse(".wasm");
        open("m=torus&decoder=wasm");
        browser.await("window.jsm?.state === 'error'");
        // The round that was wished meanwhile ends, too, and must not hide the reason.
        browser.call("await jsm.refine();");
        assertThat(browser.text("#alert-text")).contains("The decoder could not be loaded", ".wasm: HTTP status 500");
        assertThat(browser.isShown("#retry")).isFalse();
    }

    @Test
    void shouldDecodeWithJavaScriptWhereWebAssemblyCannotBeLoaded() throws IOException {
        connectWithNothingKept();
        proxy.refuse(".wasm");
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        assertThat(text("jsm.decoder")).isEqualTo("js");
    }

    @Test
    void shouldGoOnPlainlyWhereThreeCannotBeLoadedAndTryAgain() throws IOException {
        String stage = text("await (async () => {"
                + "const names = (await (await fetch('m/torus/')).text()).match(/viewer\\/[\\w-]+\\.js/g);"
                + "const scripts = await Promise.all(names.map(async (name) => (await fetch(name)).text()));"
                + "return scripts.join().match(/stage-\\w+\\.js/)[0]; })()");
        connectWithNothingKept();
        proxy.refuse(stage);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(browser.text("#alert-text")).contains("Part of the page could not be loaded", "drawn plainly");
        assertThat(browser.call("return document.getElementById('model').view.isWhole;"))
                .isEqualTo(false);
        proxy.refuse(null);
        browser.click("#retry");
        browser.await("document.getElementById('model')?.view?.isWhole && jsm.state !== 'loading'");
        assertThat(browser.isShown("#alert")).isFalse();
    }

    @Test
    void shouldReadOnByRangesWhenTheConnectionBreaksThatTheServerPlanned() {
        proxy.bytesPerSecond(LINK / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        awaitSilence();
        browser.call("document.getElementById('server-plan').click();");
        browser.call("await jsm.refine();"); // makes whole the batch that was cut
        awaitSilence();
        proxy.cutAfter(5_000);
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
        proxy.bytesPerSecond(LINK / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.delayMillis(2500).bytesPerSecond(LINK); // what is asked for comes within the grace on a busy machine, too
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
        proxy.bytesPerSecond(LINK / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.delayMillis(60_000);
        browser.click("#more");
        browser.await("jsm.state === 'error'");
        assertThat(browser.text("#alert-text")).contains("The server is silent", "10 s");
        proxy.bytesPerSecond(FAST).delayMillis(0);
        browser.click("#retry");
        browser.await("jsm.state !== 'error'");
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
    }

    @Test
    void shouldResumeAtTheByteWhereTheConnectionBroke() {
        proxy.bytesPerSecond(LINK / 2);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.bytesPerSecond(4 * LINK).cutAfter(32_123);
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(browser.call("return jsm.error;")).isNull();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(archiveExchanges()).anyMatch(e -> e.ifRange() != null);
        assertThatEveryByteCameOnce();
    }

    @Test
    void shouldReportADamagedArchiveAndShowWhatCameBefore() throws Exception {
        int damaged = archive.length - 1000;
        ArchiveDecoder before = new ArchiveDecoder();
        before.feed(archive, 0, damaged);
        proxy.bytesPerSecond(LINK / 2);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        proxy.bytesPerSecond(FAST).corruptByte(damaged);
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(text("jsm.state")).isEqualTo("error");
        assertThat(browser.text("#alert-text")).contains("The archive is damaged");
        assertThat(browser.isShown("#retry")).isFalse();
        assertThat(browser.call("return jsm.identical;")).isEqualTo(false);
        assertThat(browser.isShown("#proof")).isFalse();
        assertThat(number("jsm.faces")).isEqualTo(before.faces());
    }

    @Test
    void shouldStopAtTheBudgetOfTheDeviceAndGoOnWhenAsked() {
        proxy.bytesPerSecond(LINK / 4);
        open("m=torus");
        browser.await("window.jsm?.state === 'idle'");
        // More may be on its way, which the budget holds back, too.
        double faces = number(
                "await (async () => { const { faces, totalFaces } = jsm;"
                        + "document.getElementById('model').setAttribute('max-faces', (faces + totalFaces) / 2); return faces; })()");
        proxy.bytesPerSecond(FAST);
        browser.click("#original");
        browser.await("jsm.state === 'idle' && jsm.isFull");
        double total = number("jsm.totalFaces");
        assertThat(number("jsm.faces")).isBetween(faces, (faces + total) / 2).isLessThan(total);
        browser.await("document.getElementById('notice').textContent.startsWith('Refinement stopped at')");
        assertThat(browser.isShown("#notice")).isTrue();
        assertThat(browser.isShown("#alert")).isFalse();
        browser.click("#original");
        browser.await("jsm.state === 'complete' || jsm.state === 'error'");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        browser.await("document.getElementById('notice').hidden");
    }

    @ParameterizedTest
    @ValueSource(strings = {"#original", "#more"})
    void shouldSayInWordsThatTheServerIsGone(String button) throws IOException {
        proxy.bytesPerSecond(LINK / 2);
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
