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
        server.put(
                "/blank.html", "<!doctype html><title>decoder</title><link rel=icon href=viewer/icon.svg>".getBytes());
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
        "MIRRORED, js"
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
                const { loadDecoder } = await import('/viewer/decoder.js');
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
