package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.encoder.ArchiveFile;
import org.jsmesh.encoder.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.jsmesh.mesh.MeshIdentity;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The commands on one small model, through the same entry as the command line. */
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

    @Test
    void shouldReportWhatItEncoded() throws Exception {
        Path out = folder.resolve("torus.jsm");
        Cli cli = Cli.ok("encode", original, "-o", out, "--json");
        JsonNode rows = new ObjectMapper().readTree(cli.out());
        assertThat(rows).hasSize(1);
        JsonNode row = rows.get(0);
        assertThat(row.get("input").asText()).isEqualTo(original.toString());
        assertThat(row.get("output").asText()).isEqualTo(out.toString());
        assertThat(row.get("faces").asInt()).isEqualTo(FACES);
        assertThat(row.get("vertices").asInt()).isEqualTo(FACES / 2);
        assertThat(row.get("baseFaces").asInt()).isEqualTo(index.faces(0));
        assertThat(row.get("bytes").asLong()).isEqualTo(Files.size(out));
        assertThat(row.get("batches").asInt()).isEqualTo(index.size());
        assertThat(row.get("encodeSeconds").asDouble()).isPositive();
        assertThat(row.get("repaired")).isEmpty();
        assertThat(row.get("dropped")).isEmpty();
        assertThat(row.get("error").isNull()).isTrue();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 5})
    void shouldWriteTheSameBytesWithAnyNumberOfThreads(int threads) throws IOException {
        Path out = folder.resolve("again.jsm");
        Cli.ok("encode", original, "-o", out, "--threads", threads);
        assertThat(out).hasSameBinaryContentAs(archive);
    }

    @Test
    void shouldKeepTheOrder() throws IOException {
        Path archiveInOrder = folder.resolve("ordered.jsm");
        Path again = folder.resolve("again.ply");
        Cli.ok("encode", original, "-o", archiveInOrder, "--keep-order");
        Path fetched = folder.resolve("fetched.ply");
        Cli.ok("decode", archiveInOrder, "-o", again);
        Cli.ok("fetch", archiveInOrder.toUri(), "-o", fetched, "--full");
        Mesh expected = ModelFiles.read(original).mesh();
        for (Path file : new Path[] {again, fetched}) {
            Mesh mesh = ModelFiles.read(file).mesh();
            assertThat(mesh.positions()).isEqualTo(expected.positions());
            assertThat(mesh.faceWedges()).isEqualTo(expected.faceWedges());
        }
        Cli.ok("decode", archive, "-o", again);
        assertThat(ModelFiles.read(again).mesh().positions()).isNotEqualTo(expected.positions());
    }

    @Test
    void shouldSimplifyByThePaperInLevels() throws IOException {
        Path out = folder.resolve("paper.jsm");
        Cli.ok("encode", original, "-o", out, "--simplifier", "paper", "--levels", ".1,.3,10");
        ArchiveFile file = ArchiveFile.read(out);
        List<ArchiveHeader.Level> levels = file.header().levels();
        assertThat(levels).extracting(ArchiveHeader.Level::threshold).containsExactly(10.0, (double) .3f, (double) .1f);
        assertThat(levels).extracting(ArchiveHeader.Level::faces).isSorted().endsWith(FACES);
        assertThat(file.header().batches().precisionBits(0)).isEqualTo(32);
        Path shown = folder.resolve("shown.ply");
        Cli.ok("decode", out, "-o", shown, "--level", 1);
        assertThat(ModelFiles.read(shown).mesh().faces())
                .isEqualTo(levels.get(0).faces());
        Cli.ok("verify", out, original);
        assertThat(Cli.ok("info", out).out()).contains("0           base", "1          10.00", "3         0.1000");
    }

    @Test
    void shouldNameABadInputAndWriteTheOthers() throws IOException {
        Path good = Bumpy.write(folder.resolve("good.ply"), 12);
        Path bad = Files.writeString(folder.resolve("bad.ply"), Bumpy.torus(12).replaceFirst("\n3 ", "\n3 99999 "));
        Path missing = folder.resolve("missing.ply");
        Path out = folder.resolve("out");
        Cli cli = Cli.run("encode", bad, missing, good, "-o", out, "--json");
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err().lines()).hasSize(2);
        assertThat(cli.err()).contains("bad.ply", "missing.ply: no such file");
        assertThat(out.resolve("good.jsm")).exists();
        try (var files = Files.list(out)) {
            assertThat(files).hasSize(1);
        }
        JsonNode rows = new ObjectMapper().readTree(cli.out());
        assertThat(rows.get(0).get("error").asText()).contains("bad.ply");
        assertThat(rows.get(2).get("error").isNull()).isTrue();
    }

    @Test
    void shouldEncodeAFolder() throws IOException {
        Path in = Files.createDirectories(folder.resolve("in/deep"));
        Bumpy.write(in.resolve("one.ply"), 12);
        Bumpy.write(in.getParent().resolve("two.ply"), 15);
        Cli.ok("encode", in.getParent(), "-o", folder.resolve("out"));
        assertThat(folder.resolve("out/deep/one.jsm")).exists();
        assertThat(folder.resolve("out/two.jsm")).exists();
    }

    @Test
    void shouldSayWhatIsWrongWithTheOutput() {
        Cli cli = Cli.run("encode", original, original, "-o", archive);
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err()).containsOnlyOnce("\n").contains("several archives need a folder");
    }

    @Test
    void shouldPrintNothingWhenQuiet() {
        Cli cli = Cli.ok("encode", original, "-o", folder.resolve("x.jsm"), "--quiet");
        assertThat(cli.out()).isEmpty();
        assertThat(cli.err()).isEmpty();
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
        assertThat(Cli.ok("verify", archive, original).out()).startsWith("identical: " + FACES + " faces");
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

    private int facesOf(Object... lod) throws IOException {
        Path out = folder.resolve("lod.ply");
        Cli.ok("decode", archive, "-o", out, lod[0], lod[1]);
        return ModelFiles.read(out).mesh().faces();
    }

    private Path cut(long end) throws IOException {
        return Files.write(folder.resolve("cut.jsm"), Arrays.copyOf(Files.readAllBytes(archive), (int) end));
    }
}
