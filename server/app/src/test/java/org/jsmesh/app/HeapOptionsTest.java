package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.jsmesh.app.heap.HeapPlan;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.EncodeJob;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HeapOptionsTest {
    private static final HeapPlan PLAN = new HeapPlan(64 << 20, 4L << 30, false);

    @TempDir
    private Path folder;

    @Test
    void shouldPlanForWhatCanBeEncoded() throws IOException {
        EncodeJob usual = stl("usual.stl", 1_000_000);
        EncodeJob giant = stl("giant.stl", 200_000_000);
        EncoderSettings one = EncoderSettings.defaults().withThreads(1);
        long heap = HeapOptions.heapFor(List.of(usual), one, PLAN);
        assertThat(heap).isBetween(100L << 20, PLAN.mostBytes());
        assertThat(HeapOptions.heapFor(List.of(giant), one, PLAN)).isZero();
        assertThat(HeapOptions.heapFor(List.of(giant, usual, stl("small.stl", 100)), one, PLAN))
                .isEqualTo(heap);
    }

    @Test
    void shouldPlanForWhatIsPackedInFewBytes() throws IOException {
        EncoderSettings one = EncoderSettings.defaults().withThreads(1);
        EncodeJob plain = text("plain.obj", "v 0 0 0\n".repeat(200_000));
        EncodeJob dense = new EncodeJob(folder.resolve("dense.stl.gz"), folder.resolve("dense.jsm"));
        try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(dense.input()))) {
            Files.copy(stl("dense.stl", 1_000_000).input(), out);
        }
        assertThat(Files.size(dense.input())).isLessThan(Files.size(plain.input()));
        long heap = HeapOptions.heapFor(List.of(dense), one, PLAN);
        assertThat(heap).isGreaterThan(300L << 20);
        assertThat(HeapOptions.heapFor(List.of(plain, dense), one, PLAN)).isEqualTo(heap);
        List<EncodeJob> catalogue = new ArrayList<>();
        for (int i = 0; i < 600; i++) catalogue.add(stl(i + ".stl", 1600));
        catalogue.add(dense);
        catalogue.add(plain);
        assertThat(Files.size(catalogue.get(0).input()))
                .as("more than 500 files are larger")
                .isGreaterThan(Files.size(dense.input()));
        assertThat(HeapOptions.heapFor(catalogue, one, PLAN)).isEqualTo(heap);
        EncoderSettings two = EncoderSettings.defaults().withThreads(2);
        assertThat(HeapOptions.heapFor(List.of(plain, dense, dense), two, PLAN)).isBetween(heap * 3 / 2, heap * 2);
    }

    private EncodeJob text(String name, String text) throws IOException {
        return new EncodeJob(Files.writeString(folder.resolve(name), text), folder.resolve(name + ".jsm"));
    }

    @Test
    void shouldSayThatAHeapHasNoEffect() throws IOException {
        Path model = Files.writeString(folder.resolve("a.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        Path out = folder.resolve("a.jsm");
        Cli within = Cli.ok("encode", model, "-o", out, "--max-heap", "99g");
        assertThat(within.err())
                .contains("--max-heap has no effect, because the command runs within another program", "-Xmx101376m");
        Cli both = Cli.run("encode", model, "-o", out, "--max-heap", "99g", "--no-relaunch");
        assertThat(both.code()).isEqualTo(2);
        assertThat(both.err()).contains("--no-relaunch forbids it", "-Xmx101376m");
    }

    /** A file with holes. */
    private EncodeJob stl(String name, int faces) throws IOException {
        Path path = folder.resolve(name);
        try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw")) {
            file.seek(80);
            file.writeInt(Integer.reverseBytes(faces));
            file.setLength(84 + 50L * faces);
        }
        return new EncodeJob(path, folder.resolve(name + ".jsm"));
    }
}
