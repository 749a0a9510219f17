package org.jsmesh.archive;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Properties;
import java.util.concurrent.ForkJoinPool;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.MeshEncoder;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.RandomMeshes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The same mesh and settings give the same bytes, on any JVM, with any number of threads, and as they were when they were last recorded. After a change of the format or of the encoder,
 * {@code mvn -pl core test -Dtest=GoldenArchiveTest -Djsm.golden=record} records them anew.
 */
class GoldenArchiveTest {
    private static final String RECORDED = "golden-archives.properties";

    @ParameterizedTest
    @EnumSource
    void shouldEncodeToTheRecordedBytes(RandomMeshes kind) throws Exception {
        if (isRecording()) return;
        assertThat(digest(kind, 1)).isEqualTo(recorded().getProperty(kind.name()));
        assertThat(digest(kind, 3)).isEqualTo(recorded().getProperty(kind.name()));
    }

    @Test
    void shouldRecordWhenAskedTo() throws Exception {
        if (!isRecording()) return;
        StringBuilder lines = new StringBuilder("# SHA-256 of the archive and of the mesh\n");
        for (RandomMeshes kind : RandomMeshes.values())
            lines.append(kind).append('=').append(digest(kind, 1)).append('\n');
        Files.writeString(Path.of("src/test/resources/org/jsmesh/archive", RECORDED), lines);
    }

    private static boolean isRecording() {
        return "record".equals(System.getProperty("jsm.golden"));
    }

    private static String digest(RandomMeshes kind, int threads) throws Exception {
        EncoderSettings settings =
                EncoderSettings.defaults().withBaseFaces(4).withThreads(threads).withKeepOrder(true);
        byte[] bytes = new MeshEncoder(settings, ForkJoinPool.commonPool())
                .encode(kind.mesh(21), ProgressListener.NONE)
                .bytes();
        byte[] sha = MessageDigest.getInstance("SHA-256").digest(bytes);
        return HexFormat.of().formatHex(sha) + " " + MeshIdentity.sha256(Archives.mesh(bytes));
    }

    private static Properties recorded() throws IOException {
        Properties properties = new Properties();
        try (InputStream in = GoldenArchiveTest.class.getResourceAsStream(RECORDED)) {
            properties.load(new java.io.InputStreamReader(in, StandardCharsets.UTF_8));
        }
        return properties;
    }
}
