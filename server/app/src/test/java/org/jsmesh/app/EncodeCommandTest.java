package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.archive.ArchiveHeader;
import org.jsmesh.archive.BatchIndex;
import org.jsmesh.files.ArchiveFile;
import org.jsmesh.files.ModelFiles;
import org.jsmesh.mesh.Mesh;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code jsm encode} on one small model, through the same entry as the command line. */
class EncodeCommandTest {
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
    void shouldSayWhichAxisPointsUp() throws Exception {
        Path out = folder.resolve("up.jsm");
        Cli.ok("encode", original, "-o", out, "--up", "z");
        assertThat(Cli.ok("info", out).out()).contains("the z axis points up");
        assertThat(new ObjectMapper()
                        .readTree(Cli.ok("info", out, "--json").out())
                        .get("up")
                        .asText())
                .isEqualTo("z");
        assertThat(Cli.ok("info", archive).out()).doesNotContain("axis points up");
        Cli glb = Cli.ok("decode", out, "-o", folder.resolve("up.glb"));
        assertThat(glb.err()).contains("a node turns the model");
        assertThat(Cli.run("encode", original, "-o", out, "--up", "x").err())
                .contains("'x' is no axis that points up, use y or z");
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
        assertThat(row.get("notes")).isEmpty();
        assertThat(row.get("error").isNull()).isTrue();
    }

    @Test
    void shouldShowNotesAsObjectsAndAsSentences() throws IOException {
        Path loose = Files.writeString(
                folder.resolve("loose.obj"), "o thing\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nl 1 2\nf 1 2 3\n");
        Path out = folder.resolve("loose.jsm");
        Cli cli = Cli.ok("encode", loose, "-o", out, "--json");
        assertThat(new ObjectMapper().readTree(cli.out()).get(0).get("notes"))
                .isEqualTo(new ObjectMapper().readTree("""
                        [{"kind":"dropped","text":"Lines left out: l (1). jSM streams triangles.","count":1,"example":"line 6","warning":true},
                        {"kind":"dropped","text":"1 vertex that no face refers to dropped.","count":1,"example":"vertex 3","warning":false}]
                        """));
        assertThat(Cli.ok("encode", loose, "-o", out).err().lines())
                .containsExactly(
                        loose + ": warning: Lines left out: l (1). jSM streams triangles.",
                        loose + ": 1 vertex that no face refers to dropped.");
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
}
