package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Properties;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Test;

/**
 * Whoever keeps archives trusts {@link ModelEncoding#VERSION}: while it stays, the same models give the same bytes. The
 * bytes of some models are recorded with it. Where they change, raise the version and run the test once with
 * {@code -Djsm.results=record}.
 */
class EncoderVersionTest {
    private static final Path RECORD = SampleModels.project()
            .resolve("server/encoder/src/test/resources/org/jsmesh/files/encoder-version.properties");

    /** A painted model, points with normals, and a scene. */
    private static final List<String> MODELS = List.of(
            "models/amphora.obj",
            "models/octopus.ply",
            "server/encoder/src/test/resources/org/jsmesh/files/gltf/compressed/plain.glb");

    @Test
    void shouldChangeWithTheBytesThatItStandsFor() throws Exception {
        MessageDigest bytes = MessageDigest.getInstance("SHA-256");
        ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults().withThreads(2));
        for (String model : MODELS)
            bytes.update(encoding.encode(SampleModels.project().resolve(model), ProgressListener.NONE)
                    .bytes());
        String sha256 = HexFormat.of().formatHex(bytes.digest());
        if (System.getProperty("jsm.results", "").equals("record")) record(sha256);
        Properties recorded = recorded();
        assertThat(sha256 + " of version " + ModelEncoding.VERSION)
                .as("models give other bytes: raise ModelEncoding.VERSION and record them")
                .isEqualTo(recorded.getProperty("sha256") + " of version " + recorded.getProperty("version"));
    }

    private static Properties recorded() throws IOException {
        Properties recorded = new Properties();
        try (InputStream in = Files.newInputStream(RECORD)) {
            recorded.load(in);
        }
        return recorded;
    }

    private static void record(String sha256) throws IOException {
        String text = "version=" + ModelEncoding.VERSION + "\nsha256=" + sha256 + "\n";
        Files.write(RECORD, text.getBytes(StandardCharsets.US_ASCII));
    }
}
