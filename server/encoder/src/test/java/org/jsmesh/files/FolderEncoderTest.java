package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.memory.MemoryAdmission;
import org.jsmesh.mesh.MeshComparison;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderEncoderTest {
    @TempDir
    private Path folder;

    @Test
    void shouldEncodeManyFilesAndAnswerInTheirOrder() throws Exception {
        List<EncodeJob> jobs = new ArrayList<>();
        for (int i = 0; i < 5; i++)
            jobs.add(new EncodeJob(hill("hill" + i + ".off", 30 - 5 * i), folder.resolve("out/hill" + i + ".jsm")));
        List<EncodeJob> heard = new ArrayList<>();
        FolderEncodeListener listener = new FolderEncodeListener() {
            @Override
            public void finished(EncodeJob job, EncodeResult result) {
                heard.add(job);
            }
        };
        List<EncodeResult> results =
                new FolderEncoder(EncoderSettings.defaults().withThreads(3)).encode(jobs, listener);
        assertThat(results.stream().map(EncodeResult::output))
                .containsExactlyElementsOf(
                        jobs.stream().map(j -> j.output().toString()).toList());
        assertThat(results).noneMatch(EncodeResult::isFailed);
        assertThat(heard).containsExactlyInAnyOrderElementsOf(jobs);
        for (EncodeJob job : jobs) {
            var decoded = ArchiveFile.read(job.output()).original(ProgressListener.NONE);
            assertThat(MeshComparison.firstDifference(
                            ModelFiles.read(job.input()).mesh(), decoded))
                    .isEmpty();
        }
    }

    @Test
    void shouldFailAloneWithPlaceAndRemedy() throws Exception {
        Path bad = Files.writeString(folder.resolve("bad.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n");
        List<EncodeJob> jobs = List.of(
                new EncodeJob(bad, folder.resolve("bad.jsm")),
                new EncodeJob(hill("good.off", 8), folder.resolve("good.jsm")));
        List<EncodeResult> results =
                new FolderEncoder(EncoderSettings.defaults()).encode(jobs, FolderEncodeListener.NONE);
        assertThat(results.get(0).error()).contains("bad.off", "line 5");
        assertThat(results.get(1).error()).isNull();
        assertThat(folder.resolve("bad.jsm")).doesNotExist();
        assertThat(folder.resolve("good.jsm")).exists();
    }

    /** As a class is that could not be loaded when memory had run out. */
    @Test
    void shouldFailAloneByAnErrorOfTheMachine() throws Exception {
        List<EncodeJob> jobs = List.of(
                new EncodeJob(hill("bad.off", 8), folder.resolve("bad.jsm")),
                new EncodeJob(hill("good.off", 9), folder.resolve("good.jsm")));
        FolderEncodeListener breaking = new FolderEncodeListener() {
            @Override
            public void progress(EncodeJob job, String stage, double fraction) {
                if (job == jobs.get(0) && stage.equals("cleaning")) throw new NoClassDefFoundError("Some");
            }
        };
        List<EncodeResult> results = new FolderEncoder(EncoderSettings.defaults()).encode(jobs, breaking);
        assertThat(results.get(0).error()).contains("bad.off", "NoClassDefFoundError: Some");
        assertThat(results.get(1).error()).isNull();
        assertThat(folder.resolve("good.jsm")).exists();
    }

    @Test
    void shouldEndAllWorkWhenTheListenerFails() throws Exception {
        List<EncodeJob> jobs = List.of(
                new EncodeJob(hill("a.off", 8), folder.resolve("a.jsm")),
                new EncodeJob(hill("b.off", 40), folder.resolve("b.jsm")),
                new EncodeJob(hill("c.off", 40), folder.resolve("c.jsm")));
        FolderEncodeListener failing = new FolderEncodeListener() {
            @Override
            public void finished(EncodeJob job, EncodeResult result) {
                throw new IllegalArgumentException("no more");
            }
        };
        assertThatThrownBy(() -> new FolderEncoder(EncoderSettings.defaults()).encode(jobs, failing))
                .isInstanceOf(IllegalStateException.class)
                .hasRootCauseMessage("no more");
    }

    @Test
    void shouldLeaveNothingBehindWhenCancelled() throws Exception {
        Path out = folder.resolve("out");
        List<EncodeJob> jobs = List.of(
                new EncodeJob(hill("a.off", 40), out.resolve("a.jsm")),
                new EncodeJob(hill("b.off", 40), out.resolve("b.jsm")));
        FolderEncodeListener impatient = new FolderEncodeListener() {
            private volatile boolean cancelled;

            @Override
            public void progress(EncodeJob job, String stage, double fraction) {
                if (!stage.equals("reading")) cancelled = true;
            }

            @Override
            public boolean isCancelled() {
                return cancelled;
            }
        };
        FolderEncoder encoder = new FolderEncoder(EncoderSettings.defaults().withThreads(2));
        assertThatThrownBy(() -> encoder.encode(jobs, impatient)).isInstanceOf(CancellationException.class);
        assertThat(out).doesNotExist();
    }

    @Test
    void shouldTellWhatWasDropped() throws Exception {
        Path input = Files.writeString(
                folder.resolve("loose.off"), "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n7 7 7\n3 0 1 2\n3 2 1 3\n");
        EncodeResult result = new FolderEncoder(EncoderSettings.defaults())
                .encode(List.of(new EncodeJob(input, folder.resolve("loose.jsm"))), FolderEncodeListener.NONE)
                .get(0);
        assertThat(result.vertices()).isEqualTo(4);
        assertThat(result.notes())
                .containsExactly(Note.dropped("1 vertex that no face refers to dropped.", 1, "vertex 4"));
    }

    @Test
    void shouldAdmitAsManyAsFitTheMemory() throws Exception {
        MemoryAdmission narrow = new MemoryAdmission(1000); // each one is larger
        List<EncodeJob> jobs = new ArrayList<>();
        for (int i = 0; i < 4; i++)
            jobs.add(new EncodeJob(hill("narrow" + i + ".off", 10 + i), folder.resolve("narrow" + i + ".jsm")));
        AtomicInteger most = new AtomicInteger();
        FolderEncodeListener watch = new FolderEncodeListener() {
            @Override
            public void progress(EncodeJob job, String stage, double fraction) {
                most.accumulateAndGet(narrow.inside(), Math::max);
            }
        };
        FolderEncoder encoder = new FolderEncoder(EncoderSettings.defaults().withThreads(4)).withMemory(narrow);
        assertThat(encoder.encode(jobs, watch)).noneMatch(EncodeResult::isFailed);
        assertThat(most).hasValue(1);
        assertThat(narrow.taken()).isZero();
    }

    @Test
    void shouldTryAModelOnceMoreAloneWhenMemoryIsUsedUp() throws Exception {
        MemoryAdmission gate = new MemoryAdmission(1L << 40);
        MemoryAdmission.Admission beside = gate.admit(1);
        EncodeJob job = new EncodeJob(hill("tried.off", 8), folder.resolve("tried.jsm"));
        List<Integer> company = new ArrayList<>();
        FolderEncodeListener failing = new FolderEncodeListener() {
            @Override
            public void progress(EncodeJob which, String stage, double fraction) {
                if (!stage.equals("writing")) return;
                company.add(gate.inside());
                beside.close();
                if (company.size() == 1) throw new OutOfMemoryError("as if");
            }
        };
        FolderEncoder encoder = new FolderEncoder(EncoderSettings.defaults()).withMemory(gate);
        EncodeResult result = encoder.encode(List.of(job), failing).get(0);
        assertThat(result.error()).isNull();
        assertThat(company).containsExactly(2, 1);
    }

    @Test
    void shouldTellWhenAModelTakesMoreMemoryThanThereIs() throws Exception {
        EncodeJob job = new EncodeJob(hill("large.off", 8), folder.resolve("large.jsm"));
        FolderEncodeListener failing = new FolderEncodeListener() {
            @Override
            public void progress(EncodeJob which, String stage, double fraction) {
                throw new OutOfMemoryError("as if");
            }
        };
        assertThat(new FolderEncoder(EncoderSettings.defaults()).encode(List.of(job), failing))
                .singleElement()
                .satisfies(result -> assertThat(result.error()).contains("large.off: needs more memory than", "-Xmx"));
    }

    @Test
    void shouldTryOnceMoreWhenAHeaderIsReadWithoutRoom() throws Exception {
        Path large = folder.resolve("large.stl"); // with holes; it needs nearly all of the heap
        int faces = (int) Math.min(Integer.MAX_VALUE, Runtime.getRuntime().maxMemory() / 280);
        try (RandomAccessFile file = new RandomAccessFile(large.toFile(), "rw")) {
            file.seek(80);
            file.writeInt(Integer.reverseBytes(faces));
            file.setLength(84 + 50L * faces);
        }
        List<String> warnings = new ArrayList<>();
        FolderEncodeListener failing = new FolderEncodeListener() {
            @Override
            public void warned(EncodeJob which, String text) {
                warnings.add(text);
                if (warnings.size() == 1) throw new OutOfMemoryError("as if");
            }

            @Override
            public void progress(EncodeJob which, String stage, double fraction) {
                throw new IllegalArgumentException("it began");
            }
        };
        List<EncodeJob> jobs = List.of(new EncodeJob(large, folder.resolve("large.jsm")));
        assertThat(new FolderEncoder(EncoderSettings.defaults()).encode(jobs, failing))
                .singleElement()
                .satisfies(result -> assertThat(result.error()).contains("it began"));
        assertThat(warnings).hasSize(2);
        Files.delete(large);
    }

    private Path hill(String name, int side) throws IOException {
        StringBuilder off = new StringBuilder("OFF\n" + side * side + " " + 2 * (side - 1) * (side - 1) + " 0\n");
        for (int y = 0; y < side; y++) {
            for (int x = 0; x < side; x++)
                off.append(String.format(Locale.ROOT, "%d %d %.3f\n", x, y, 5 * Math.sin(.2 * x) * Math.cos(.3 * y)));
        }
        for (int y = 0; y + 1 < side; y++) {
            for (int x = 0; x + 1 < side; x++) {
                int a = y * side + x;
                off.append("3 " + a + " " + (a + 1) + " " + (a + side) + "\n3 " + (a + 1) + " " + (a + side + 1) + " "
                        + (a + side) + "\n");
            }
        }
        return Files.writeString(folder.resolve(name), off);
    }
}
