package org.jsmesh.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.decode.ArchiveDecoder;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.mesh.io.ModelReader;
import org.jsmesh.web.testing.Browser;
import org.jsmesh.web.testing.PageServer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The decoder gives the same mesh, bit for bit, on HotSpot, as WebAssembly and as JavaScript, after every batch that is
 * looked at.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class DecoderParityTest {
    private static final int LOOKS = 9;
    private static final Path MODELS = Path.of("../../models");

    @TempDir
    static Path profile;

    private PageServer server;
    private Browser browser;

    @BeforeAll
    void start() throws IOException {
        browser = new Browser(profile);
        server = new PageServer();
        server.put("/blank.html", "<!doctype html><title>decoder</title><link rel=icon href=data:,>".getBytes());
    }

    @AfterAll
    void stop() {
        if (browser != null) browser.close();
        if (server != null) server.close();
    }

    @ParameterizedTest
    @CsvSource({
        "ROUND, wasm",
        "ROUND, js",
        "COLOURED, wasm",
        "COLOURED, js",
        "SEAMED, wasm",
        "SEAMED, js",
        "MIRRORED, wasm",
        "MIRRORED, js",
        "SURVEYED, wasm",
        "SURVEYED, js",
        "MEASURED, wasm",
        "MEASURED, js"
    })
    void shouldDecodeTheSameEverywhere(TestShapes shape, String decoder) throws IOException {
        shouldDecodeTheSame(shape.mesh(), decoder);
    }

    /** Long enough and with enough ties for a last bit to matter. */
    @ParameterizedTest
    @ValueSource(strings = {"octopus.ply", "planetary-gear.obj", "amphora.obj"})
    void shouldDecodeTheSamplesTheSameEverywhere(String model) throws IOException {
        Mesh mesh = ModelReader.read(model, Files.readAllBytes(MODELS.resolve(model)), DecoderParityTest::resource)
                .mesh();
        shouldDecodeTheSame(mesh, "wasm");
        shouldDecodeTheSame(mesh, "js");
    }

    /** As far as it knows the archive: up to exact attributes, or the last batch. */
    @ParameterizedTest
    @CsvSource({"ROUND, 2", "COLOURED, 2", "SEAMED, 2", "MIRRORED, 2", "SURVEYED, 2", "MEASURED, 2"})
    void shouldDrawTheSameWithTheFirstDecoder(TestShapes shape, int least) throws IOException {
        shouldDrawTheSame(shape.mesh(), least);
    }

    @Test
    void shouldDrawASampleTheSameWithTheFirstDecoder() throws IOException {
        byte[] model = Files.readAllBytes(MODELS.resolve("octopus.ply"));
        shouldDrawTheSame(
                ModelReader.read("octopus.ply", model, DecoderParityTest::resource)
                        .mesh(),
                6);
    }

    private void shouldDrawTheSame(Mesh mesh, int least) throws IOException {
        byte[] archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, ProgressListener.NONE)
                .bytes();
        server.put("/shape.jsm", archive);
        browser.open(server.address("/blank.html"));
        long[] ends = ends(archive);
        List<?> found = (List<?>) browser.call("""
                const { loadDecoder, relayed } = await import('/modules/decode/load-decoder.js');
                const { instantiate } = await import('/modules/decoder/first-decoder.js');
                const archive = new Uint8Array(await (await fetch('/shape.jsm')).arrayBuffer());
                const first = relayed(instantiate(), () => new Promise(() => {}));
                const whole = await loadDecoder('wasm');
                const different = [];
                let looks = 0;
                let from = 0;
                for (const end of args[0]) {
                  const part = archive.subarray(from, end);
                  first.feed(part);
                  whole.feed(part);
                  from = end;
                  if (first.batches < whole.batches) break;
                  looks++;
                  const [shown, expected] = [first.refine(), whole.refine()];
                  for (const name of ['ranges', 'data', 'groups', 'vertices', 'faces', 'step']) {
                    const [a, b] = [shown[name], expected[name]].map((value) => (typeof value === 'number' ? [value] : Array.from(value)));
                    const isSame = a.length === b.length && a.every((value, i) => value === b[i]);
                    if (!isSame) different.push(`${name} of batch ${whole.batches}`);
                  }
                  const late = { words: null, meshSha256: null, modelSha256: null };
                  const [said, known] = [first, whole].map(({ header }) => JSON.stringify(Object.entries({ ...header, ...late }).sort()));
                  if (said !== known) different.push(`header at batch ${whole.batches}`);
                }
                return [different, looks];
                """, LongStream.of(ends).boxed().toList());
        assertThat((List<?>) found.get(0)).isEmpty();
        assertThat((Long) found.get(1)).isGreaterThanOrEqualTo(least);
        assertThat(browser.consoleErrors()).isEmpty();
    }

    /** The whole decoder has images and proof. */
    @Test
    void shouldHandOverToTheWholeDecoder() throws IOException {
        byte[] archive = DecodingSessionTest.archive("sky.png");
        server.put("/shape.jsm", archive);
        browser.open(server.address("/blank.html"));
        List<?> found = (List<?>) browser.call("""
                const { loadDecoder } = await import('/modules/decode/load-decoder.js');
                const { instantiate } = await import('/modules/decoder/first-decoder.js');
                const archive = new Uint8Array(await (await fetch('/shape.jsm')).arrayBuffer());
                const decoder = await loadDecoder('first', instantiate);
                const wasFirst = decoder.isFirst;
                for (let from = 0; from < archive.length; from += 100) decoder.feed(archive.subarray(from, from + 100));
                await decoder.catchUp();
                return [wasFirst, decoder.isFirst, decoder.isComplete, decoder.proof().difference, decoder.header.whole,
                  decoder.newImages(new Set()).length];
                """);
        assertThat(found).isEqualTo(List.of(true, false, true, "", true, 1L));
    }

    private static Optional<byte[]> resource(String name) throws IOException {
        Path file = MODELS.resolve(name);
        return Files.exists(file) ? Optional.of(Files.readAllBytes(file)) : Optional.empty();
    }

    private void shouldDecodeTheSame(Mesh mesh, String decoder) throws IOException {
        byte[] archive = new MeshEncoder(EncoderSettings.defaults())
                .encode(mesh, ProgressListener.NONE)
                .bytes();
        server.put("/shape.jsm", archive);
        browser.open(server.address("/blank.html"));
        long[] ends = ends(archive);
        assertThat(decodeInBrowser(decoder, ends)).isEqualTo(decodeHere(archive, ends));
        assertThat(browser.consoleErrors()).isEmpty();
    }

    private List<String> decodeHere(byte[] archive, long[] ends) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        List<String> hashes = new ArrayList<>();
        int from = 0;
        for (long end : ends) {
            decoder.feed(archive, from, (int) end - from);
            from = (int) end;
            hashes.add(decoder.batches() + " " + MeshIdentity.sha256(decoder.mesh()));
        }
        return hashes;
    }

    private List<?> decodeInBrowser(String decoder, long[] ends) {
        return (List<?>) browser.call("""
                const { loadDecoder } = await import('/modules/decode/load-decoder.js');
                const archive = new Uint8Array(await (await fetch('/shape.jsm')).arrayBuffer());
                const decoder = await loadDecoder(args[0]);
                if (decoder.kind !== args[0]) throw new Error(`asked for ${args[0]}, got ${decoder.kind}`);
                const hashes = [];
                let from = 0;
                for (const end of args[1]) {
                  decoder.feed(archive.subarray(from, end));
                  from = end;
                  hashes.push(`${decoder.batches} ${decoder.sha256()}`);
                }
                return hashes;
                """, decoder, LongStream.of(ends).boxed().toList());
    }

    /** Ends of the base, of some batches between, and of the archive. */
    private static long[] ends(byte[] archive) throws IOException {
        ArchiveDecoder decoder = new ArchiveDecoder();
        decoder.feed(archive, 0, archive.length);
        BatchIndex index = decoder.header().batches();
        int last = index.size() - 1;
        return LongStream.rangeClosed(0, LOOKS)
                .map(i -> index.end((int) (i * last / LOOKS)))
                .distinct()
                .toArray();
    }
}
