package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.assertj.core.api.SoftAssertions;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.archive.BatchKind;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.mesh.MeshIdentity;
import org.jsmesh.mesh.Note;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every sample model through encode, verify, decode; and what docs/format.md promises of its batches. */
@Tag("long")
@Tag("slow")
class EveryModelTest {
    /** Models of 10,000 faces or more whose creases or seams keep the base large. */
    private static final Set<String> SHARP = Set.of("fandisk.m", "cessna.m", "kip.obj", "planetary-gear.obj");

    @TempDir
    private Path folder;

    static List<Path> models() {
        return SampleModels.all();
    }

    @ParameterizedTest
    @MethodSource("models")
    void shouldComeBackFromAnArchiveOfGoodBatches(Path model) throws IOException {
        Path archive = folder.resolve("alone.jsm");
        Cli.ok("encode", model, "-o", archive);
        ArchiveFile file = ArchiveFile.read(archive);
        boolean isWhole = file.header().provenance().notes().stream().noneMatch(Note::warning);
        assertThat(Cli.ok("verify", archive, model).out())
                .startsWith(isWhole ? "identical" : "warning: not the whole original")
                .contains("bit for bit");
        String name = model.getFileName().toString();
        checkBatches(name, file);
        if (name.equals("stanford-bunny.obj"))
            assertThat(8.0 * file.length() / file.header().vertices())
                    .as("bits per vertex")
                    .isLessThan(50);
        checkCut(archive, file.header().batches());
    }

    private static void checkBatches(String name, ArchiveFile file) {
        BatchIndex index = file.header().batches();
        SoftAssertions softly = new SoftAssertions();
        softly.assertThat(index.kind(0)).isEqualTo(BatchKind.BASE);
        softly.assertThat(index.offset(0)).isZero();
        softly.assertThat(index.archiveBytes()).as("batches tile the file").isEqualTo(file.length());
        softly.assertThat(index.faces(index.size() - 1)).isEqualTo(file.header().faces());
        softly.assertThat(index.errorMean(index.size() - 1)).isZero();
        for (int i = 1; i < index.size(); i++) {
            softly.assertThat(index.offset(i)).as("offset of batch " + i).isEqualTo(index.end(i - 1));
            softly.assertThat(index.faces(i)).as("faces after batch " + i).isGreaterThanOrEqualTo(index.faces(i - 1));
            long most = i == index.poster() ? 8192 : Math.min(65536, Math.max(1024, index.offset(i) / 20));
            softly.assertThat((long) index.bytes(i)).as("bytes of batch " + i).isBetween(1L, most);
        }
        if (file.header().faces() >= 10_000) {
            softly.assertThat(index.size()).as("batches").isGreaterThanOrEqualTo(15);
            if (!SHARP.contains(name)) {
                softly.assertThat(index.end(0))
                        .as("bytes of the base of " + index.archiveBytes())
                        .isLessThanOrEqualTo(index.archiveBytes() / 50);
            }
        }
        softly.assertAll();
    }

    /** A file cut after a batch shows the same as the whole file after that batch. */
    private static void checkCut(Path archive, BatchIndex index) throws IOException {
        byte[] bytes = Files.readAllBytes(archive);
        ArchiveFile whole = ArchiveFile.of(bytes);
        for (int k : new int[] {0, index.size() / 3, 2 * index.size() / 3}) {
            ArchiveFile cut = ArchiveFile.of(Arrays.copyOf(bytes, (int) index.end(k)));
            assertThat(cut.batches()).isEqualTo(k + 1);
            assertThat(MeshIdentity.sha256(cut.meshAfter(k, ProgressListener.NONE)))
                    .as("batch " + k)
                    .isEqualTo(MeshIdentity.sha256(whole.meshAfter(k, ProgressListener.NONE)));
            assertThat(whole.meshAfter(k, ProgressListener.NONE).faces())
                    .as("faces after batch " + k)
                    .isEqualTo(index.faces(k));
        }
    }
}
