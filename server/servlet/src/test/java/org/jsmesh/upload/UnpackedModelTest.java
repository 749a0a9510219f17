package org.jsmesh.upload;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Models that are sent as ZIP archives. */
class UnpackedModelTest extends UploadQueueFixture {
    @Test
    void shouldBlameNamesThatNoFolderTakes() throws Exception {
        settings = settings.withMostBytes(10_000);
        open(copying());
        send("a", "zip", zip("x", "file", "x/chair.obj", "obj"));
        assertThat(await("a").error()).contains("file and a folder");
        send("b", "zip", zip("x/chair.obj", "obj", "x", "file"));
        assertThat(await("b").error()).contains("file and a folder");
        send("c", "zip", zip("x".repeat(300) + ".obj", "obj"));
        assertThat(await("c").error()).contains("too long");
        send("d", "zip", zip(("x".repeat(200) + "/").repeat(10) + "chair.obj", "obj"));
        assertThat(await("d").error()).contains("too long");
        assertThat(encoded).isEmpty();
    }

    @Test
    void shouldUnpackAModelWithItsMaterials() throws Exception {
        open((model, archive, progress) -> {
            assertThat(model.resolveSibling("tex/wood.png")).hasContent("wood");
            copying().encode(model, archive, progress);
        });
        send("chair", "zip", zip("chair.obj", "obj", "chair.mtl", "mtl", "tex/wood.png", "wood", "readme.txt", "x"));
        assertThat(await("chair").error()).isNull();
        assertThat(encoded).containsExactly("obj");
    }

    @ParameterizedTest
    @ValueSource(strings = {"../x.obj", "/etc/x.obj", "a/../../x.obj", "..\\x.obj", "a/../.", "x\0.obj"})
    void shouldNotUnpackOutOfTheFolder(String name) throws Exception {
        open(copying());
        send("chair", "zip", zip(name, "evil"));
        assertThat(await("chair").state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(encoded).isEmpty();
        try (Stream<Path> all = Files.walk(folder)) {
            assertThat(all.filter(f -> f.getFileName().toString().contains("x.obj")))
                    .isEmpty();
        }
    }

    @Test
    void shouldNotUnpackBombs() throws Exception {
        open(copying());
        send("a", "zip", zip("big.obj", "x".repeat(100_000)));
        assertThat(await("a").error()).contains("more bytes than allowed");
        send("b", "zip", "no zip".getBytes(StandardCharsets.UTF_8));
        assertThat(await("b").error()).contains("no ZIP archive");
        send("c", "zip", zip("a.obj", "1", "b.ply", "2"));
        assertThat(await("c").error()).contains("2 model files");
        byte[] whole = zip("a.obj", "1".repeat(300));
        send("d", "zip", java.util.Arrays.copyOf(whole, 40));
        assertThat(await("d").state()).isEqualTo(UploadStatus.State.FAILED);
        assertThat(encoded).isEmpty();
        assertThat(spool()).isEmpty();
    }

    @Test
    void shouldUnpackWhereTheFolderIsNamedByDots() throws Exception {
        Path dotted = folder.resolve(".").resolve("up").resolve("..").resolve("up");
        queue = new UploadQueue(settings, dotted, copying(), () -> {});
        send("chair", "zip", zip("chair.obj", "obj"));
        assertThat(await("chair").error()).isNull();
        assertThat(encoded).containsExactly("obj");
    }

    @Test
    void shouldCountWhatHidesInFoldersOfBombs() throws Exception {
        open(copying());
        send("a", "zip", zip("folder/", "x".repeat(100_000), "chair.obj", "obj"));
        assertThat(await("a").error()).contains("more bytes than allowed");
        assertThat(encoded).isEmpty();
    }

    @Test
    void shouldNotMakeFoldersWithoutEnd() throws Exception {
        open(copying());
        send("a", "zip", zip("a/".repeat(40) + "chair.obj", "obj"));
        assertThat(await("a").error()).contains("too deep");
        assertThat(encoded).isEmpty();
    }
}
