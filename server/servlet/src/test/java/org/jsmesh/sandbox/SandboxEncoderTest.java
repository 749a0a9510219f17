package org.jsmesh.sandbox;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.files.ModelInputs;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.Await;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Real processes. */
@Timeout(120)
class SandboxEncoderTest {
    private static final String TETRAHEDRON = "mtllib parts/wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl wood\n"
            + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

    @TempDir
    Path folder;

    private Path model(String text) throws IOException {
        return Files.writeString(folder.resolve("model.obj"), text);
    }

    private Path archive() {
        return folder.resolve("work.jsm");
    }

    /** A grid of so many points a side. */
    private static String grid(int side) {
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i < side * side; i++)
            obj.append("v ").append(i / side).append(' ').append(i % side).append(" 0\n");
        for (int i = 0; i < side - 1; i++) {
            for (int j = 1; j < side; j++) {
                int p = i * side + j;
                obj.append("f ")
                        .append(p)
                        .append(' ')
                        .append(p + 1)
                        .append(' ')
                        .append(p + side)
                        .append('\n');
            }
        }
        return obj.toString();
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void shouldGiveTheBytesOfTheLibraryAndTellWhatItRead() throws Exception {
        Path model = model(TETRAHEDRON);
        Files.writeString(
                Files.createDirectory(folder.resolve("parts")).resolve("wood.mtl"), "newmtl wood\nKd 1 0 0\n");
        List<String> stages = new CopyOnWriteArrayList<>();
        ModelInputs inputs =
                SandboxEncoder.of(SandboxLimits.defaults()).encode(model, archive(), (stage, f) -> stages.add(stage));
        ModelInputs expected = new ModelInputs();
        byte[] bytes = new ModelEncoding(EncoderSettings.defaults())
                .encode(model, expected, ProgressListener.NONE)
                .bytes();
        assertThat(archive()).hasBinaryContent(bytes);
        assertThat(inputs).isEqualTo(expected);
        assertThat(stages).contains("reading");
        assertThat(names()).containsExactly("model.obj", "parts", "work.jsm");
    }

    @Test
    void shouldSayWhyAModelCannotBeEncoded() throws Exception {
        SandboxEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults().withMostFaces(3));
        assertThatThrownBy(() -> encoder.encode(model("v 0 0 0\n"), archive(), ProgressListener.NONE))
                .isInstanceOf(EncodingFailure.class)
                .hasMessageContaining("the model");
        assertThatThrownBy(() -> encoder.encode(model(TETRAHEDRON), archive(), ProgressListener.NONE))
                .isInstanceOfSatisfying(EncodingFailure.class, e -> {
                    assertThat(e).hasMessageContaining("4 faces");
                    assertThat(e.isPassing()).isFalse();
                    assertThat(e.remedy()).isNotBlank();
                });
        assertThat(names()).containsExactly("model.obj");
    }

    @Test
    void shouldEndAModelThatNeedsTooMuchMemory() throws Exception {
        SandboxEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults().withHeapMegabytes(32));
        assertThatThrownBy(() -> encoder.encode(model(grid(500)), archive(), ProgressListener.NONE))
                .isInstanceOf(EncodingFailure.class)
                .hasMessageContaining("memory");
        assertThat(names()).containsExactly("model.obj");
    }

    @Test
    void shouldRefuseAModelByItsHeaderWhenItCannotFit() throws Exception {
        Path model = folder.resolve("model.stl");
        try (RandomAccessFile file = new RandomAccessFile(model.toFile(), "rw")) {
            file.seek(80);
            file.writeInt(Integer.reverseBytes(100_000_000)); // triangles
            file.setLength(84 + 50 * 100_000_000L); // with holes
        }
        SandboxEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults().withHeapMegabytes(2048));
        assertThatThrownBy(() -> encoder.encode(model, archive(), ProgressListener.NONE))
                .isInstanceOfSatisfying(EncodingFailure.class, e -> {
                    assertThat(e).hasMessageContaining("GiB of heap memory, and the limit is 2.0 GiB");
                    assertThat(e.remedy()).isEqualTo("send a smaller model");
                    assertThat(e.isPassing()).isFalse();
                });
        Files.delete(model);
    }

    @Test
    void shouldEndAModelThatTakesTooLong() throws Exception {
        SandboxEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults().withEncodeMillis(300));
        assertThatThrownBy(() -> encoder.encode(model(grid(300)), archive(), ProgressListener.NONE))
                .isInstanceOf(EncodingFailure.class)
                .hasMessageContaining("longer than");
        assertNoProcess();
    }

    @Test
    void shouldEndWhenItIsCancelled() throws Exception {
        SandboxEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults());
        Path model = model(grid(300));
        ProgressListener cancelling = new ProgressListener() {
            private volatile boolean heard;

            @Override
            public void progress(String stage, double fraction) {
                heard = true;
            }

            @Override
            public boolean isCancelled() {
                return heard;
            }
        };
        assertThatThrownBy(() -> encoder.encode(model, archive(), cancelling))
                .isInstanceOf(CancellationException.class);
        assertNoProcess();
    }

    private void assertNoProcess() throws Exception {
        String mark = folder.toString();
        Await.until(
                "the end of the process",
                () -> ProcessHandle.allProcesses()
                        .noneMatch(p -> p.info().commandLine().orElse("").contains(mark)));
    }
}
