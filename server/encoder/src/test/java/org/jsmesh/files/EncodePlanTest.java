package org.jsmesh.files;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class EncodePlanTest {
    @TempDir
    private Path folder;

    @Test
    void shouldTakeTheOutputAsAFileForOneInput() {
        Path out = folder.resolve("x.jsm");
        assertThat(EncodePlan.of(folder.resolve("bunny.ply"), out))
                .containsExactly(new EncodeJob(folder.resolve("bunny.ply"), out));
        assertThat(EncodePlan.of(folder.resolve("bunny.ply"), folder))
                .containsExactly(new EncodeJob(folder.resolve("bunny.ply"), folder.resolve("bunny.jsm")));
    }

    @Test
    void shouldTakeTheModelsOfAFolderAtAnyDepthInOneOrder() throws IOException {
        Path in = Files.createDirectory(folder.resolve("in"));
        Path deep = Files.createDirectories(in.resolve("deep/er"));
        touch(
                in.resolve("b.ply"),
                in.resolve("a.OBJ"),
                in.resolve("a.mtl"),
                in.resolve("README.md"),
                in.resolve(".c.stl"),
                deep.resolve("d.m"));
        Path out = folder.resolve("out");
        assertThat(EncodePlan.of(List.of(in), out, EncodePlanTest::fail))
                .containsExactly(
                        new EncodeJob(in.resolve("a.OBJ"), out.resolve("a.jsm")),
                        new EncodeJob(in.resolve("b.ply"), out.resolve("b.jsm")),
                        new EncodeJob(deep.resolve("d.m"), out.resolve("deep/er/d.jsm")));
    }

    @Test
    void shouldKeepTheExtensionWhereNamesWouldMeet() throws IOException {
        Path out = folder.resolve("out");
        List<Path> inputs = List.of(Path.of("x/a.ply"), Path.of("y/a.obj"), Path.of("b.stl"));
        assertThat(EncodePlan.of(inputs, out, EncodePlanTest::fail).stream().map(EncodeJob::output))
                .containsExactly(out.resolve("a.ply.jsm"), out.resolve("a.obj.jsm"), out.resolve("b.jsm"));
    }

    @Test
    void shouldRefuseTwoInputsForOnePlace() {
        assertThatThrownBy(() ->
                        EncodePlan.of(List.of(Path.of("x/a.ply"), Path.of("y/a.ply")), folder, EncodePlanTest::fail))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("a.ply.jsm");
    }

    @Test
    void shouldSayWhenAFolderHoldsNoModel() {
        assertThatThrownBy(() -> EncodePlan.of(List.of(folder), folder.resolve("out"), EncodePlanTest::fail))
                .isInstanceOf(FileSystemException.class)
                .hasMessageContaining(folder.toString())
                .hasMessageContaining("holds no model file");
    }

    @Test
    void shouldRefuseAnArchiveInPlaceOfAnInput() throws IOException {
        Path in = folder.resolve("a.jsm");
        Path link = folder.resolve("link.jsm");
        touch(in);
        Files.createSymbolicLink(link, in);
        for (Path out : List.of(in, link, folder))
            assertThatThrownBy(() -> EncodePlan.of(in, out))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessageContaining("would replace an input");
        assertThatThrownBy(() -> EncodePlan.of(List.of(folder.resolve("b.ply"), in), folder, EncodePlanTest::fail))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(in.toString());
    }

    /** A path that is too long cannot be listed, not even by root, whom permissions do not stop. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void shouldGoOnBehindAFolderThatCannotBeListed() throws IOException {
        String deep = ("x".repeat(200) + "/").repeat(11);
        Path in = folder.resolve("in");
        Path outer = Files.createDirectories(in.resolve("a").resolve(deep));
        Path inner = folder.resolve("inner");
        Files.createDirectories(inner.resolve(deep));
        touch(in.resolve("z.ply"));
        Files.move(inner, outer.resolve("inner"));
        List<IOException> unreadable = new ArrayList<>();
        try {
            assertThat(EncodePlan.of(List.of(in), folder.resolve("out"), unreadable::add))
                    .extracting(EncodeJob::input)
                    .containsExactly(in.resolve("z.ply"));
        } finally {
            Files.move(outer.resolve("inner"), inner);
        }
        assertThat(unreadable).singleElement().isInstanceOf(FileSystemException.class);
    }

    private static void fail(IOException e) {
        throw new AssertionError(e);
    }

    private static void touch(Path... files) throws IOException {
        for (Path file : files) Files.createFile(file);
    }
}
