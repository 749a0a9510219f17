package org.jsmesh.files.gltf.packed;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.Tag;

/** The first five bytes of an input choose mode, filter, stride and count. */
@Tag("slow")
class MeshoptFuzzTest {
    private static final String[] MODES = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
    private static final String[] FILTERS = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"};

    @FuzzTest(maxDuration = "1m")
    void shouldThrowNothingButPackedException(byte[] content) {
        if (content.length < 5) return;
        ByteBuffer input = ByteBuffer.wrap(content);
        String mode = MODES[Byte.toUnsignedInt(input.get()) % MODES.length];
        String filter = FILTERS[Byte.toUnsignedInt(input.get()) % FILTERS.length];
        int stride = Byte.toUnsignedInt(input.get());
        int count = Short.toUnsignedInt(input.getShort());
        try {
            assertThat(MeshoptDecoder.decode(input, count, stride, mode, filter))
                    .hasSize(count * stride);
        } catch (PackedException e) {
            assertThat(e.reason()).isNotBlank();
        }
        assertThat(input.position()).isEqualTo(5);
    }
}
