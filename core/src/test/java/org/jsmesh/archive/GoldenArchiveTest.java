package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.concurrent.ForkJoinPool;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.encode.Quality;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The same mesh and settings give the same bytes, on any JVM, with any number of threads, and as they were when they
 * were last recorded. After a wanted change of the format or of the encoder, the file that the test leaves in
 * {@code target} becomes the recorded one.
 */
class GoldenArchiveTest {
    private static final String RECORDED = "golden-archives.properties";

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void shouldEncodeToTheRecordedBytes(int threads) throws Exception {
        StringBuilder lines = new StringBuilder("# SHA-256 of the archive and of the mesh\n");
        for (RandomMeshes kind : RandomMeshes.values()) {
            lines.append(kind).append('=').append(digests(kind, threads, Quality.DEFAULT));
            lines.append('\n').append(kind).append(".fast=").append(digests(kind, threads, Quality.FAST));
            lines.append('\n');
        }
        Files.writeString(Path.of("target", RECORDED), lines);
        assertThat(lines.toString())
                .as("copy core/target/%s to core/src/test/resources/org/jsmesh/archive if this was meant", RECORDED)
                .isEqualTo(recorded());
    }

    private static String digests(RandomMeshes kind, int threads, Quality quality) throws Exception {
        EncoderSettings settings = EncoderSettings.defaults()
                .withBaseFaces(4)
                .withThreads(threads)
                .withKeepOrder(true)
                .withQuality(quality);
        byte[] bytes = new MeshEncoder(settings, ForkJoinPool.commonPool())
                .encode(kind.mesh(21), ProgressListener.NONE)
                .bytes();
        byte[] sha = MessageDigest.getInstance("SHA-256").digest(bytes);
        return HexFormat.of().formatHex(sha) + " " + MeshIdentity.sha256(TestArchives.mesh(bytes));
    }

    private static String recorded() throws IOException {
        try (InputStream in = GoldenArchiveTest.class.getResourceAsStream(RECORDED)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
