package org.jsmesh.files.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import java.util.Optional;
import org.jsmesh.mesh.io.ModelFile;
import org.jsmesh.mesh.io.ModelFormatException;
import org.junit.jupiter.api.Tag;

/**
 * Runs the seeds beside it with the full set of tests; fuzzes for a minute with JAZZER_FUZZ=1 and only this test
 * chosen.
 */
@Tag("slow")
class GltfReaderFuzzTest {
    @FuzzTest(maxDuration = "1m")
    void shouldThrowNothingButModelFormatException(byte[] content) throws IOException {
        try {
            ModelFile file = GltfReader.read("fuzz.glb", content, path -> Optional.empty());
            for (float value : file.mesh().positions()) assertThat(value).isFinite();
        } catch (ModelFormatException e) {
            assertThat(e.reason()).isNotBlank();
        }
    }
}
