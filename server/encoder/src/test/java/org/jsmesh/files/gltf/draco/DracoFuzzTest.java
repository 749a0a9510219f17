package org.jsmesh.files.gltf.draco;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.ByteBuffer;
import org.jsmesh.files.gltf.packed.PackedException;
import org.junit.jupiter.api.Tag;

/** Starts from the meshes beside it. */
@Tag("slow")
class DracoFuzzTest {
    @FuzzTest(maxDuration = "1m")
    void shouldThrowNothingButPackedException(byte[] content) {
        try {
            DracoMesh mesh = DracoDecoder.decode(ByteBuffer.wrap(content), 1 << 20, 1 << 20);
            for (int index : mesh.indices()) assertThat(index).isBetween(0, mesh.points() - 1);
            for (DracoAttribute attribute : mesh.attributes().values()) {
                assertThat(attribute.values()).hasSize(mesh.points() * attribute.components() * size(attribute));
            }
        } catch (PackedException e) {
            assertThat(e.reason()).isNotBlank();
        }
    }

    private static int size(DracoAttribute attribute) {
        return switch (attribute.componentType()) {
            case 5120, 5121 -> 1;
            case 5122, 5123 -> 2;
            default -> 4;
        };
    }
}
