package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.MeshIdentity;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands but {@code encode} on one small model, through the same entry as the command line. */
class CommandsTest {
    private static final int FACES = 2 * 90 * 30;

    @TempDir
    private static Path model;

    @TempDir
    private Path folder;

    private static Path original;
    private static Path archive;
    private static BatchIndex index;

    @BeforeAll
    static void encode() throws Exception {
        original = Bumpy.write(model.resolve("torus.ply"), 90);
        archive = model.resolve("torus.jsm");
        Cli.ok("encode", original, "-o", archive);
        index = ArchiveFile.read(archive).header().batches();
    }

    @ParameterizedTest
    @ValueSource(strings = {"ply", "obj", "stl", "off", "m", "glb"})
    void shouldDecodeTheOriginalInEveryFormat(String extension) throws IOException {
        Path out = folder.resolve("torus." + extension);
        assertThat(Cli.ok("decode", archive, "-o", out).out()).contains(FACES + " faces", "the original");
        assertThat(MeshIdentity.sha256(ModelFiles.read(out).mesh()))
                .isEqualTo(ArchiveFile.read(archive).header().meshSha256());
    }

    @Test
    void shouldDecodeTheResolutionAskedFor() throws IOException {
        int middle = index.size() / 2;
        assertThat(facesOf("--faces", index.faces(middle))).isEqualTo(index.faces(middle));
        assertThat(facesOf("--faces", 0)).isEqualTo(index.faces(0));
        assertThat(facesOf("--faces", 1_000_000)).isEqualTo(FACES);
        assertThat(facesOf("--batch", middle)).isEqualTo(index.faces(middle));
        assertThat(facesOf("--batch", 0)).isEqualTo(index.faces(0));
        assertThat(facesOf("--bytes", index.end(middle))).isEqualTo(index.faces(middle));
        assertThat(facesOf("--bytes", index.end(middle) - 1)).isEqualTo(index.faces(middle - 1));
        assertThat(facesOf("--error", index.errorMean(middle) + "%")).isLessThanOrEqualTo(index.faces(middle));
        assertThat(facesOf("--error", "0")).isEqualTo(FACES);
        assertThat(facesOf("--level", 0)).isEqualTo(index.faces(0));
        assertThat(facesOf(
                        "--level", ArchiveFile.read(archive).header().levels().size()))
                .isEqualTo(FACES);
    }

    @Test
    void shouldDecodeTheFacesThatInfoNamesForEachLevel() throws IOException {
        List<ArchiveHeader.Level> levels = ArchiveFile.read(archive).header().levels();
        assertThat(levels).hasSizeGreaterThan(3);
        for (int i = 0; i < levels.size(); i++)
            assertThat(facesOf("--level", i + 1))
                    .as("level %d", i + 1)
                    .isEqualTo(levels.get(i).faces());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--batch 9999", "--batch -1", "--level 999", "--bytes 10"})
    void shouldSayWhichResolutionsThereAre(String lod) {
        String[] words = lod.split(" ");
        Cli cli = Cli.run("decode", archive, "-o", folder.resolve("x.ply"), words[0], words[1]);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).containsOnlyOnce("\n").contains("Ask for", archive.toString());
        assertThat(folder.resolve("x.ply")).doesNotExist();
    }

    @Test
    void shouldDecodeWhatACutFileHolds() throws IOException {
        int middle = index.size() / 2;
        Path cut = cut(index.end(middle) + 3);
        Cli refused = Cli.run("decode", cut, "-o", folder.resolve("x.ply"));
        assertThat(refused.code()).isEqualTo(1);
        assertThat(refused.err()).containsOnlyOnce("\n").contains("is cut", "Fetch the rest", "--batch " + middle);
        Path fromCut = folder.resolve("cut.ply");
        Path fromWhole = folder.resolve("whole.ply");
        Cli.ok("decode", cut, "-o", fromCut, "--batch", middle);
        Cli.ok("decode", archive, "-o", fromWhole, "--batch", middle);
        assertThat(fromCut).hasSameBinaryContentAs(fromWhole);
        assertThat(Cli.ok("decode", cut, "-o", fromCut, "--faces", FACES).out())
                .contains(index.faces(middle) + " faces");
        assertThat(Cli.run("decode", cut, "-o", fromCut, "--batch", middle + 1).err())
                .contains("cut after batch " + middle);
        assertThat(Cli.run("verify", cut, original).code()).isEqualTo(1);
        assertThat(Cli.ok("info", cut).err()).contains("is cut");
    }

    @Test
    void shouldRefuseAnArchiveWithAChangedBit() throws IOException {
        byte[] bytes = Files.readAllBytes(archive);
        bytes[bytes.length * 2 / 3] ^= 4;
        Path changed = Files.write(folder.resolve("changed.jsm"), bytes);
        for (Cli cli : new Cli[] {
            Cli.run("decode", changed, "-o", folder.resolve("x.ply")), Cli.run("verify", changed, original)
        }) {
            assertThat(cli.code()).isEqualTo(1);
            assertThat(cli.err()).containsOnlyOnce("\n").contains(changed.toString());
        }
        assertThat(folder.resolve("x.ply")).doesNotExist();
    }

    @Test
    void shouldVerifyTheOriginalAndNameAFloatChangedInItsLastBit() throws IOException {
        assertThat(Cli.ok("verify", archive, original).out())
                .startsWith("identical to the original file's geometry, materials and pictures")
                .contains(FACES + " faces, mesh SHA-256");
        String text = Files.readString(original);
        float first = Float.parseFloat(
                text.substring(text.indexOf("end_header\n") + 11).split(" ")[0]);
        String changedText = text.replaceFirst("end_header\n\\S+", "end_header\n" + Math.nextUp(first));
        Path changed = Files.writeString(folder.resolve("changed.ply"), changedText);
        Cli cli = Cli.run("verify", archive, changed);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains(
                        "position x differs in its last bit",
                        "0x" + Integer.toHexString(Float.floatToRawIntBits(first)),
                        "vertex 0");
    }

    @Test
    void shouldTellWhatAnArchiveHolds() throws IOException {
        JsonNode info =
                new ObjectMapper().readTree(Cli.ok("info", archive, "--json").out());
        assertThat(info.get("faces").asInt()).isEqualTo(FACES);
        assertThat(info.get("bytes").asLong()).isEqualTo(Files.size(archive));
        assertThat(info.get("archiveSha256").asText())
                .isEqualTo(ArchiveFile.read(archive).sha256());
        assertThat(info.get("batches")).hasSize(index.size());
        assertThat(Cli.ok("info", archive).out())
                .contains(FACES + " faces", info.get("meshSha256").asText(), "bits per vertex");
    }

    @Test
    void shouldSimulateAVisitorToTheEnd() throws IOException {
        JsonNode rounds = new ObjectMapper()
                .readTree(Cli.ok("simulate", archive, "--kbps", 16, "--wait", "500ms", "--json")
                        .out())
                .get("rounds");
        assertThat(rounds.size()).isGreaterThan(3);
        JsonNode last = rounds.get(rounds.size() - 1);
        assertThat(last.get("faces").asInt()).isEqualTo(FACES);
        assertThat(last.get("bytes").asLong()).isEqualTo(index.archiveBytes());
        assertThat(Cli.ok("simulate", archive, "--kbps", 16, "--rounds", 2)
                        .out()
                        .lines())
                .hasSize(3);
    }

    @Tag("slow")
    @Test
    void shouldMeasureSpeedAndHeap() throws IOException {
        Path small = Bumpy.write(folder.resolve("small.ply"), 24);
        JsonNode bench =
                new ObjectMapper().readTree(Cli.ok("bench", small, "--json").out());
        assertThat(bench.get("faces").asInt()).isEqualTo(2 * 24 * 8);
        assertThat(bench.get("bytes").asLong()).isPositive();
        for (String name : new String[] {"encodeFacesPerSecond", "decodeFacesPerSecond", "codingFacesPerSecond"}) {
            assertThat(bench.get(name).asDouble()).as(name).isPositive();
        }
        assertThat(bench.get("codingFacesPerSecond").asDouble())
                .isGreaterThan(bench.get("encodeFacesPerSecond").asDouble());
        assertThat(bench.get("encodePeakHeapBytes").asLong()).isPositive();
        assertThat(bench.get("decodePeakHeapBytes").asLong()).isPositive();
    }

    @Tag("slow")
    @Test
    void shouldMeasureAWholeEncoding() throws IOException {
        Path small = Bumpy.write(folder.resolve("whole.ply"), 24);
        JsonNode bench = new ObjectMapper()
                .readTree(Cli.ok("bench", small, "--whole", "--threads", 2, "--quality", "fast", "--json")
                        .out());
        assertThat(bench.get("faces").asInt()).isEqualTo(2 * 24 * 8);
        assertThat(bench.get("bytes").asLong()).isPositive();
        assertThat(bench.get("threads").asInt()).isEqualTo(2);
        assertThat(bench.get("peakHeapBytesPerFace").asDouble()).isPositive();
        for (String when : new String[] {"first", "again"}) {
            assertThat(bench.get(when).get("facesPerSecond").asDouble()).isPositive();
            List<String> stages = new ArrayList<>();
            bench.get(when).get("stages").forEach(s -> stages.add(s.get("name").asText()));
            assertThat(stages).contains("reading", "cleaning", "coding", "writing");
        }
        assertThat(Cli.ok("bench", small, "--whole").out()).contains("bytes per face", "at first", "again", "coding");
    }

    private int facesOf(Object... lod) throws IOException {
        Path out = folder.resolve("lod.ply");
        Cli.ok("decode", archive, "-o", out, lod[0], lod[1]);
        return ModelFiles.read(out).mesh().faces();
    }

    private Path cut(long end) throws IOException {
        return Files.write(folder.resolve("cut.jsm"), Arrays.copyOf(Files.readAllBytes(archive), (int) end));
    }
}
