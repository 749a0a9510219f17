package org.jsmesh.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.jsmesh.mesh.Mesh;
import org.junit.jupiter.api.Tag;

/**
 * Runs the seeds beside it with the full set of tests; fuzzes for a minute with JAZZER_FUZZ=1 and only this test
 * chosen. The input is the model part, for fuzzing seldom gets behind the checksums of an archive.
 */
@Tag("slow")
class ThreeMfReaderFuzzTest {
    @FuzzTest(maxDuration = "1m")
    void shouldThrowNothingButModelFormatException(byte[] model) throws IOException {
        byte[] content = ThreeMfSamples.file(new String(model, StandardCharsets.UTF_8));
        Mesh mesh;
        try {
            mesh = ModelReader.read("fuzz.3mf", content, ResourceResolver.NONE).mesh();
        } catch (ModelFormatException e) {
            assertThat(e.reason()).isNotBlank();
            assertThat(e.remedy()).isNotBlank();
            return;
        }
        for (float value : mesh.positions()) assertThat(value).isFinite();
    }
}
