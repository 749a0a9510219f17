package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.PageServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What Java answers arrives in JavaScript as it was meant, from WebAssembly and from compiled JavaScript. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class DecoderAnswersTest {
    private static final String PATH = "a\nb\t\"8\"\\\u0001\u2028.png";

    @TempDir
    static Path profile;

    private PageServer server;
    private Browser browser;

    @BeforeAll
    void start() throws IOException {
        browser = new Browser(profile);
        server = new PageServer();
        server.put("/blank.html", "<!doctype html><title>t</title><link rel=icon href=data:,>".getBytes());
        server.put("/painted.jsm", DecodingSessionTest.archive(PATH));
        server.put("/image.png", DecodingSessionTest.IMAGE);
        browser.open(server.address("/blank.html"));
    }

    @AfterAll
    void stop() {
        if (browser != null) browser.close();
        if (server != null) server.close();
    }

    @ParameterizedTest
    @ValueSource(strings = {"wasm", "js"})
    void shouldGiveImagesByPathsWithLineBreaks(String decoder) {
        List<?> found = (List<?>) call(decoder, """
                const archive = await bytesOf('/painted.jsm');
                decoder.feed(archive);
                const [[paths, bytes], ...rest] = decoder.newImages(new Set());
                const image = await bytesOf('/image.png');
                const isSame = bytes.length === image.length && bytes.every((byte, i) => byte === image[i]);
                return [paths[0], isSame, rest.length, decoder.header.slots[1].textures.COLOUR.path];
                """);
        assertThat(found).isEqualTo(List.of(PATH, true, 0L, PATH));
    }

    @ParameterizedTest
    @ValueSource(strings = {"wasm", "js"})
    void shouldThrowWhatJavaAnswers(String decoder) {
        List<?> found = (List<?>) call(decoder, """
                const thrown = (work) => { try { work(); return 'nothing'; } catch (error) { return error; } };
                const early = thrown(() => decoder.refine());
                const damaged = thrown(() => decoder.feed(new Uint8Array(1000)));
                return [early instanceof DamagedArchive, early.message, damaged instanceof DamagedArchive];
                """);
        assertThat(found).isEqualTo(List.of(false, "the base has not arrived yet", true));
    }

    private Object call(String decoder, String body) {
        return browser.call("""
                const { DamagedArchive } = await import('/modules/decode/answers.js');
                const { loadDecoder } = await import('/modules/decode/load-decoder.js');
                const bytesOf = async (address) => new Uint8Array(await (await fetch(address)).arrayBuffer());
                const decoder = await loadDecoder(args[0]);
                """ + body, decoder);
    }
}
