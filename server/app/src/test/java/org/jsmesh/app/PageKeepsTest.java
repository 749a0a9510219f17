package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import org.jsmesh.session.testing.ProxiedExchange;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What the page keeps across visits, in a browser whose own HTTP cache is emptied between them. */
@Tag("long")
class PageKeepsTest extends PageFixture {
    /** In IndexedDB everything is asynchronous: waits for one request. */
    private static final String DATABASE =
            "const answer = r => new Promise((ok, no) => { r.onsuccess = () => ok(r.result); r.onerror = () => no(r.error); });"
                    + "const db = await answer(indexedDB.open('jsm-archives', 1));";

    @BeforeEach
    void begin() {
        proxy.bytesPerSecond(LINK / 2);
        visit("m=torus");
    }

    private void visit(String query) {
        browser.forget();
        open(query);
        browser.await(
                "window.jsm?.state === 'idle' || window.jsm?.state === 'complete' || window.jsm?.state === 'error'");
        assertThat(browser.call("return jsm.error;")).isNull();
        awaitSilence();
    }

    private long archiveBytesSent() {
        return archiveExchanges().stream().mapToLong(ProxiedExchange::bodyBytes).sum();
    }

    @Test
    void shouldResumeAtTheNextVisitWithTheFirstMissingByte() {
        long held = (long) number("jsm.bytes");
        assertThat(held).isBetween(1L, archive.length - 1L);
        int before = archiveExchanges().size();
        visit("m=torus");
        assertThat(archiveExchanges().get(before).fromByte()).isEqualTo(held);
        assertThat(archiveExchanges().subList(before, archiveExchanges().size()))
                .allMatch(e -> e.fromByte() >= held);
        assertThat(number("jsm.keptBytes")).isEqualTo(held);
        assertThat(number("jsm.bytes")).isGreaterThan(held);
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
    }

    @Test
    void shouldShowTheOriginalAgainWithoutAByteOfTheArchive() throws IOException {
        proxy.bytesPerSecond(FAST);
        browser.call("await jsm.complete();");
        long sent = archiveBytesSent();
        assertThat(number("jsm.requests.reduce((sum, r) => sum + r.bytes, 0)")).isEqualTo(archive.length);
        proxy.bytesPerSecond(LINK);
        visit("m=torus");
        assertThat(text("jsm.state")).isEqualTo("complete");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        assertThat(archiveBytesSent()).isEqualTo(sent);
        assertThat(number("jsm.requests.length")).isZero();
        assertThat(number("jsm.bytesPerSecond"))
                .as("learned from what was kept, which came at once")
                .isLessThan(2 * LINK);
        assertThat(text("document.getElementById('fine').textContent")).contains("kept by this browser");
        assertThatPictureAgrees("kept");
    }

    /** Damages or removes the piece at a byte before the middle of what is held. */
    @ParameterizedTest
    @ValueSource(strings = {"new Uint8Array(piece.data)[9] ^= 1; s.put(piece)", "s.delete(piece.key)"})
    void shouldNoticeThatWhatItKeptIsDamaged(String damage) {
        browser.call("await jsm.refine();");
        awaitSilence();
        int before = archiveExchanges().size();
        double good = ((Number) browser.call(DATABASE
                        + "const s = db.transaction('pieces', 'readwrite').objectStore('pieces');"
                        + "const pieces = await answer(s.getAll());"
                        + "const piece = pieces[Math.floor(pieces.length / 2)];"
                        + damage.replace("piece.key", "[piece.key, piece.from]")
                        + "; await answer(s.count()); return piece.from;"))
                .doubleValue();
        assertThat(good).isPositive();
        proxy.bytesPerSecond(FAST);
        visit("m=torus");
        assertThat(number("jsm.keptBytes")).isEqualTo(good);
        assertThat(archiveExchanges().get(before).fromByte()).isEqualTo((long) good);
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
    }

    @Test
    void shouldBeginAgainWhenWhatItKeptIsNoArchive() {
        browser.call(DATABASE
                + "const { crc32 } = await import('/modules/decode/crc32.js');"
                + "const s = db.transaction('pieces', 'readwrite').objectStore('pieces');"
                + "const [piece] = await answer(s.getAll()); const bytes = new Uint8Array(piece.data);"
                + "bytes[50] ^= 1; await answer(s.put({ ...piece, crc: crc32(bytes) }));");
        proxy.bytesPerSecond(FAST);
        visit("m=torus");
        assertThat(number("jsm.keptBytes")).isZero();
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        visit("m=torus");
        assertThat(number("jsm.keptBytes")).isEqualTo(archive.length);
    }

    @Test
    void shouldNotGiveOneArchiveTheBytesOfAnother() throws IOException {
        // The same hash at another address is another archive, as far as can be known before its end.
        URI other = server.uri().resolve("?shading=matte&archive=" + proxy.through(archiveUri));
        browser.open(other);
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        assertThat(number("jsm.keptBytes")).isZero();
        Files.delete(model);
        GrainyTorus.write(model, AROUND, ACROSS / 2);
        try {
            visit("m=torus");
            assertThat(number("jsm.keptBytes")).isZero();
            browser.call("await jsm.complete();");
            assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        } finally {
            GrainyTorus.write(model, AROUND, ACROSS);
        }
    }

    @Test
    void shouldShowTheNewModelWhenItChangesInTheMiddle() throws IOException {
        double faces = number("jsm.totalFaces");
        GrainyTorus.write(model, AROUND, ACROSS / 2);
        try {
            browser.call("await jsm.refine();");
            // Where the server encodes the new model first, its answer may come after the round.
            browser.await("document.getElementById('notice').textContent !== '' && jsm.state === 'idle'");
            assertThat(browser.call("return jsm.error;")).isNull();
            assertThat(browser.text("#notice")).contains("was changed on the server", "This is the new one");
            assertThat(number("jsm.totalFaces")).isPositive().isLessThan(faces);
            proxy.bytesPerSecond(FAST);
            browser.call("await jsm.complete();");
            assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
            assertThat(number("jsm.faces")).isEqualTo(number("jsm.totalFaces"));
            assertThat(number("jsm.requests.reduce((sum, r) => sum + r.bytes, 0)"))
                    .isEqualTo(number("jsm.totalBytes"));
        } finally {
            GrainyTorus.write(model, AROUND, ACROSS);
        }
    }

    @Test
    void shouldKeepArchivesOfServersWithoutEncryption() {
        URI page = URI.create("http://" + Browser.INSECURE_HOST + ":" + proxy.port() + "/?shading=matte&m=torus");
        proxy.bytesPerSecond(FAST);
        for (long kept : new long[] {0, archive.length}) {
            browser.forget();
            browser.open(page);
            browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
            assertThat(browser.call("return isSecureContext;")).isEqualTo(false);
            assertThat(number("jsm.keptBytes")).isEqualTo(kept);
            browser.call("await jsm.complete();");
            assertThat(browser.call("return jsm.identical;")).isEqualTo(true);
        }
    }

    @Test
    void shouldKeepNoMoreThanItMayAndDropTheLeastRecentlyUsed() {
        Object held = browser.call("const { Kept } = await import('/modules/decode/kept.js');"
                + "const at = n => Kept.open('https://host/' + n, String(n).repeat(64), 1000);"
                + "const put = async (n, from, count) => { const k = await at(n); k.add(from, new Uint8Array(count).fill(n)); await k.flush(); };"
                + "const held = async n => { let sum = 0; for await (const p of (await at(n)).pieces()) sum += p.length; return sum; };"
                + DATABASE
                + "for (const store of ['archives', 'pieces']) await answer(db.transaction(store, 'readwrite').objectStore(store).clear());"
                + "await put(1, 0, 300); await put(2, 0, 300); await put(3, 0, 300);"
                + "await new Promise(r => setTimeout(r, 5)); await held(1);"
                + "await new Promise(r => setTimeout(r, 5)); await put(2, 500, 10); await put(3, 300, 300);"
                + "const sums = [await held(1), await held(2), await held(3)];"
                + "await put(4, 0, 2000); sums.push(await held(4)); return sums.join(' ');");
        assertThat(held).isEqualTo("300 0 600 0");
    }

    @Test
    void shouldNotWaitForADatabaseThatNeverOpens() {
        Object kept = browser.call(
                "const { Kept } = await import('/modules/decode/kept.js');"
                        + "const open = indexedDB.open; IDBFactory.prototype.open = () => new EventTarget();"
                        + "try { return await Kept.open('https://host/a', 'a'.repeat(64)); } finally { IDBFactory.prototype.open = open; }");
        assertThat(kept).isNull();
    }

    @Test
    void shouldMakeWayForWhoeverDeletesTheDatabase() {
        Object held = browser.call("const { Kept } = await import('/modules/decode/kept.js');"
                + "const at = () => Kept.open('https://host/a', 'a'.repeat(64));"
                + "const held = async k => { let sum = 0; for await (const p of k.pieces()) sum += p.length; return sum; };"
                + "const old = await at(); await at(); old.add(0, new Uint8Array(300)); await old.flush();"
                + "const sums = [await held(old)];"
                + "await new Promise((ok, no) => { const r = indexedDB.deleteDatabase('jsm-archives'); r.onsuccess = ok; r.onerror = no; });"
                + "old.add(300, new Uint8Array(300)); await old.flush(); sums.push(await held(old));"
                + "const k = await at(); k.add(0, new Uint8Array(200)); await k.flush(); sums.push(await held(k));"
                + "await k.forget(); return sums.join(' ');");
        assertThat(held).isEqualTo("300 0 200");
    }

    @Test
    void shouldUseWhatItKeepsOnAFullDisk() {
        Object held = browser.call("const { Kept } = await import('/modules/decode/kept.js');"
                + "const at = () => Kept.open('https://host/a', 'a'.repeat(64));"
                + "const k = await at(); k.add(0, new Uint8Array(300)); await k.flush();"
                + "const put = IDBObjectStore.prototype.put;"
                + "IDBObjectStore.prototype.put = () => { throw new DOMException('full', 'QuotaExceededError'); };"
                + "let sum = 0;"
                + "try { for await (const p of (await at()).pieces()) sum += p.length; } finally { IDBObjectStore.prototype.put = put; }"
                + "await k.forget(); return sum;");
        assertThat(((Number) held).intValue()).isEqualTo(300);
    }

    @Test
    void shouldWorkWhereTheBrowserKeepsNothing() {
        Object kept = browser.call(
                "const { Kept } = await import('/modules/decode/kept.js');"
                        + "const open = indexedDB.open; IDBFactory.prototype.open = () => { throw new DOMException('no', 'SecurityError'); };"
                        + "try { return await Kept.open('https://host/a', 'a'.repeat(64)); } finally { IDBFactory.prototype.open = open; }");
        assertThat(kept).isNull();
    }
}
