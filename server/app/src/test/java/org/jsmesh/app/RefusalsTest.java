package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.jsmesh.files.ModelFiles;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the commands refuse: in one line that says what, where and a remedy, and without harm to what is there. */
@Timeout(120)
class RefusalsTest {
    @TempDir
    private static Path models;

    @TempDir
    private Path folder;

    private static Path original;
    private static Path archive;
    private static Path painted;
    private static Path paintedArchive;

    @BeforeAll
    static void encode() throws Exception {
        original = Bumpy.write(models.resolve("torus.ply"), 30);
        archive = models.resolve("torus.jsm");
        Cli.ok("encode", original, "-o", archive);
        painted = paint(models.resolve("painted.obj"));
        paintedArchive = models.resolve("painted.jsm");
        Cli.ok("encode", painted, "-o", paintedArchive);
    }

    @Test
    void shouldNotReplaceTheInput() throws IOException {
        Path model = Files.copy(original, folder.resolve("x.ply"));
        Path link = Files.createSymbolicLink(folder.resolve("link.ply"), model);
        Path coded = Files.copy(archive, folder.resolve("coded.ply"));
        for (Cli cli : new Cli[] {
            Cli.run("encode", model, "-o", model),
            Cli.run("encode", model, "-o", link),
            Cli.run("encode", link, "-o", model),
            Cli.run("decode", coded, "-o", coded),
            Cli.run("fetch", coded.toUri(), "-o", coded),
            Cli.run("fetch", coded.toUri(), "-o", folder.resolve("y.ply"), "--trace", coded)
        }) {
            assertThat(cli.code()).isEqualTo(2);
            assertThat(cli.err()).containsOnlyOnce("\n").containsPattern("would replace an input|would be lost");
        }
        assertThat(model).hasSameBinaryContentAs(original);
        assertThat(link).isSymbolicLink();
        assertThat(coded).hasSameBinaryContentAs(archive);
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void shouldReplaceNothingButFiles() throws Exception {
        Path pipe = folder.resolve("pipe.ply");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor())
                .isZero();
        for (Cli cli : new Cli[] {
            Cli.run("encode", original, "-o", pipe),
            Cli.run("decode", archive, "-o", pipe),
            Cli.run("fetch", archive.toUri(), "-o", pipe)
        }) {
            assertThat(cli.code()).isEqualTo(1);
            assertThat(cli.err()).containsOnlyOnce("\n").contains("pipe.ply", "no regular file", "Choose another");
        }
        assertThat(Files.isRegularFile(pipe)).isFalse();
        assertThat(Files.exists(pipe)).isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "encode EMPTY -o x.jsm | EMPTY: holds no model file | Choose another folder.",
                "encode POINTS -o x.jsm | POINTS: the mesh has no faces: it is a point cloud | Make a mesh of the points",
                "decode EMPTY -o x.ply | EMPTY: is a folder | Name a file in it.",
                "info EMPTY | EMPTY: is a folder | Name a file in it.",
                "bench EMPTY | EMPTY: is a folder | Name a file in it.",
                "verify EMPTY EMPTY | EMPTY: is a folder | Name a file in it.",
                "simulate EMPTY --kbps 64 | EMPTY: is a folder | Name a file in it.",
                "serve POINTS --port 0 --tls-keystore POINTS | POINTS: is no keystore | JSM_KEYSTORE_PASSWORD",
                "serve POINTS --port 0 --cache POINTS | POINTS: cannot keep archives | Choose another folder with --cache",
                "fetch POINTSURL -o x.ply | POINTS | fetch the archive again",
            })
    void shouldSayWhatWhereAndARemedy(String line, String where, String remedy) throws IOException {
        Path empty = Files.createDirectory(folder.resolve("empty"));
        Path points = Files.writeString(folder.resolve("points.obj"), "v 0 0 0\nv 1 0 0\n");
        Object[] words = Arrays.stream(line.split(" "))
                .map(w -> switch (w) {
                    case "EMPTY" -> empty.toString();
                    case "POINTS" -> points.toString();
                    case "POINTSURL" -> points.toUri().toString();
                    case "x.jsm", "x.ply" -> folder.resolve(w).toString();
                    default -> w;
                })
                .toArray();
        Cli cli = Cli.run(words);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains(where.replace("EMPTY", empty.toString()).replace("POINTS", points.toString()), remedy);
        assertThat(cli.out()).isEmpty();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void shouldNameTheOutputThatCannotBeWritten() {
        Cli cli = Cli.run("encode", original, "-o", "/proc/x.jsm");
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains("/proc/x.jsm: cannot be written", "Choose another place.")
                .doesNotContain(".part");
        Cli cache = Cli.run("serve", models, "--port", "0", "--cache", "/proc/nope");
        assertThat(cache.code()).isEqualTo(1);
        assertThat(cache.err()).containsOnlyOnce("\n").contains("/proc/nope: cannot keep archives");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "decode x.jsm -o x.gltf | name it .glb",
                "decode x.jsm -o x.ply --faces -3 | no number of faces",
                "decode x.jsm -o x.ply --faces 3 --batch 2 | --faces=N",
                "encode EMPTYTEXT -o x | it is empty",
                "encode x -o EMPTYTEXT | it is empty",
                "fetch http://127.0.0.1:99999/a -o x.ply | port 99999",
                "fetch file:relative.jsm -o x.ply | file:///",
                "fetch http://h/a*b -o x.ply | at character 11; write a space as %20"
            })
    void shouldCallWrongUsageSo(String line, String reason) {
        Object[] words = Arrays.stream(line.split(" "))
                .map(w -> w.equals("EMPTYTEXT") ? "" : w.replace('*', ' '))
                .toArray();
        Cli cli = Cli.run(words);
        assertThat(cli.code()).isEqualTo(2);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains(reason, "--help")
                .doesNotContain("Error:")
                .doesNotContain("Exception");
    }

    @Test
    void shouldFailWhenStdoutTakesNoMore() {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        StringWriter err = new StringWriter();
        int code = Jsm.run(
                new PrintWriter(new PrintStream(full), true),
                new PrintWriter(err, true),
                "info",
                archive.toString(),
                "--json");
        assertThat(code).isEqualTo(1);
        assertThat(err.toString()).containsOnlyOnce("\n").contains("output", "space");
    }

    @ParameterizedTest
    @ValueSource(strings = {"obj", "glb"})
    void shouldCallTheOriginalSoWhenTheFileHoldsAll(String extension) throws IOException {
        Path out = folder.resolve("again." + extension);
        assertThat(Cli.ok("decode", paintedArchive, "-o", out).out()).contains("the original");
        assertThat(Cli.run("verify", paintedArchive, out).code()).isZero();
        assertThat(Cli.ok("fetch", paintedArchive.toUri(), "-o", out, "--full").out())
                .contains(out + ": identical to the original file's geometry, materials and pictures, SHA-256");
    }

    @ParameterizedTest
    @ValueSource(strings = {"ply", "stl", "off", "m"})
    void shouldSayWhatAFileLacksOfTheOriginal(String extension) {
        Path out = folder.resolve("again." + extension);
        for (Cli cli : new Cli[] {
            Cli.ok("decode", paintedArchive, "-o", out), Cli.ok("fetch", paintedArchive.toUri(), "-o", out, "--full")
        }) {
            assertThat(cli.out()).contains("every face of the original, but: ").doesNotContain("pictures, SHA");
            assertThat(Cli.run("verify", paintedArchive, out).code()).isEqualTo(1);
        }
    }

    @Test
    void shouldNoteTheImagesThatHaveNotComeYet() throws IOException {
        Path out = folder.resolve("small.obj");
        Cli cli = Cli.ok("decode", paintedArchive, "-o", out, "--batch", 0);
        assertThat(cli.err()).contains("2 images", "not written: one.png, two.png", "finer resolution");
        assertThat(folder.resolve("one.png")).doesNotExist();
        assertThat(Cli.ok("decode", paintedArchive, "-o", folder.resolve("all.obj"), "--bytes", 1 << 20)
                        .err())
                .doesNotContain("not written");
    }

    @Test
    void shouldSayWhichKeyOfAMaterialDiffers() throws IOException {
        Path changed = paint(folder.resolve("painted.obj"));
        Path library = folder.resolve("painted.mtl");
        Files.writeString(library, Files.readString(library).replace("Kd 1 0 0", "Kd 1 0 0.25"));
        Cli cli = Cli.run("verify", paintedArchive, changed);
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains("material \"red\": Kd is 1.0 0.0 0.0, in the original 1.0 0.0 0.25");
    }

    @Test
    void shouldRefuseMoreThanAnArchiveHolds() throws IOException {
        Path model = Files.writeString(
                folder.resolve("long.obj"), "usemtl " + "n".repeat(5000) + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Cli cli = Cli.run("encode", model, "-o", folder.resolve("long.jsm"));
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err())
                .containsOnlyOnce("\n")
                .contains("long.obj: the name of a material has 5000 bytes", "shorter name.")
                .doesNotContain("fault in jSM");
    }

    /** A torus of two materials with an image each, as OBJ with its library. */
    private static Path paint(Path obj) throws IOException {
        Path plain = obj.resolveSibling("plain.obj");
        Cli.ok("decode", archive, "-o", plain);
        StringBuilder text = new StringBuilder("mtllib painted.mtl\nusemtl red\n");
        int faces = 0;
        for (String line : Files.readAllLines(plain)) {
            if (line.startsWith("f ") && faces++ == 100) text.append("usemtl blue\n");
            text.append(line).append('\n');
        }
        Files.delete(plain);
        Files.writeString(obj.resolveSibling("one.png"), "no image that anybody looks at");
        Files.writeString(obj.resolveSibling("two.png"), "nor this");
        Files.writeString(
                obj.resolveSibling("painted.mtl"),
                "newmtl red\nKd 1 0 0\nmap_Kd one.png\nnewmtl blue\nKd 0 0 1\nmap_Kd two.png\n");
        assertThat(ModelFiles.read(Files.writeString(obj, text)).mesh().materials())
                .hasSize(2);
        return obj;
    }
}
