package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderScanTest {
    @TempDir
    Path folder;

    @Test
    void shouldNameModelsByTheirFiles() throws IOException {
        create("Stanford Bunny.obj", "Äpfel_2.PLY", "duck.glb");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("apfel-2", "duck", "stanford-bunny");
        assertThat(FolderScan.scan(folder).get("stanford-bunny").name()).isEqualTo("Stanford Bunny");
        assertThat(FolderScan.scan(folder).get("apfel-2").format()).isEqualTo("ply");
    }

    @Test
    void shouldPassOverWhatIsNoModel() throws IOException {
        create("README.md", "kip.mtl", "kip.png", ".hidden.ply", ".git/x.ply", "noextension", "kip.obj");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("kip");
    }

    @Test
    void shouldLookIntoSubFolders() throws IOException {
        create("kip/kip.obj", "deep/er/horse.ply");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("horse", "kip");
    }

    @Test
    void shouldPreferAnArchiveToItsModel() throws IOException {
        create("bunny.ply", "bunny.jsm", "sub/bunny.ply");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("bunny-jsm", "sub-bunny-ply");
    }

    @Test
    void shouldKeepIdsOfEqualNamesApart() throws IOException {
        create("cube.obj", "cube.stl", "a/cube.obj", "a-cube.obj");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("a-cube", "a-cube-obj", "cube-obj", "cube-stl");
    }

    @Test
    void shouldNumberIdsThatStillCollide() throws IOException {
        create("a b.obj", "a_b.obj");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("a-b-obj", "a-b-obj-2");
    }

    @Test
    void shouldGiveNamelessFilesAnId() throws IOException {
        create("模型.ply");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("model");
        assertThat(FolderScan.scan(folder).get("model").name()).isEqualTo("模型");
    }

    @Test
    void shouldServeASingleFile() throws IOException {
        create("one.ply", "two.ply");
        assertThat(FolderScan.scan(folder.resolve("one.ply")).keySet()).containsExactly("one");
    }

    @Test
    void shouldServeASingleFileWithoutExtension() throws IOException {
        create("Horse");
        assertThat(FolderScan.scan(folder.resolve("Horse")).keySet()).containsExactly("horse");
    }

    @Test
    void shouldTakeBothFormsOfGltf() throws IOException {
        create("a.gltf", "b.GLB", "b.bin");
        assertThat(FolderScan.scan(folder).keySet()).containsExactly("a", "b");
    }

    private void create(String... names) throws IOException {
        for (String name : names) {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            Files.writeString(file, "");
        }
    }
}
