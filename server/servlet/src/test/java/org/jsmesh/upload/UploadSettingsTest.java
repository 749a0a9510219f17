package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.memory.MemoryEstimate;
import org.jsmesh.sandbox.SandboxLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The limits of uploads fit each other: what is let in can be encoded. */
class UploadSettingsTest {
    @TempDir
    private Path folder;

    private UploadSettings defaults() throws Exception {
        return UploadSettings.of(UploadTokens.read(Files.writeString(folder.resolve("tokens"), "0123456789abcdef")));
    }

    @Test
    void shouldLetInOnlyWhatFitsTheHeap() throws Exception {
        SandboxLimits limits = defaults().sandbox();
        long heap = (long) limits.heapMegabytes() << 20;
        // the most memory that faces of a surface take: a normal, a texture coordinate and a material each
        String header = "ply\nformat binary_little_endian 1.0\nelement vertex " + limits.mostFaces() / 2
                + "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
                + "property float nz\nproperty float s\nproperty float t\nelement face " + limits.mostFaces()
                + "\nproperty list uchar int vertex_indices\nend_header\n";
        long bytes = header.length() + limits.mostFaces() / 2 * 32L + limits.mostFaces() * 13L;
        MemoryEstimate most =
                MemoryEstimate.of("most.ply", bytes, header.getBytes("US-ASCII"), EncoderSettings.defaults());
        assertThat(most.faces()).isEqualTo(limits.mostFaces());
        assertThat(most.bytes()).isBetween(heap * 3 / 4, heap);
    }

    @Test
    void shouldLetInAsManyFacesAsTheBytesOfAnUploadHold() throws Exception {
        long plainFaces = (defaults().mostBytes() - 84) / 50; // of an STL file
        assertThat(plainFaces).isBetween(defaults().mostFaces() / 2L, defaults().mostFaces() * 2L);
    }

    @Test
    void shouldTakeFewerFacesWithLessHeap() {
        assertThat(UploadSettings.facesFor(1024)).isLessThan(UploadSettings.facesFor(2048) / 2 + 100_000);
        assertThat(UploadSettings.facesFor(32)).isPositive();
        assertThat(UploadSettings.facesFor(Integer.MAX_VALUE)).isEqualTo(Integer.MAX_VALUE);
    }

    @Test
    void shouldHaveTimeForTheLargest() throws Exception {
        double facesPerSecond = 50_000; // of one processor, on a busy machine
        assertThat(defaults().mostFaces() / facesPerSecond * 1000)
                .isLessThan(defaults().encodeMillis());
    }
}
