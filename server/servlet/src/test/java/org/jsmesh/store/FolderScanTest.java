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
        assertThat(FolderScan.scan(folder).entries().keySet()).containsExactly("apfel-2", "duck", "stanford-bunny");
        assertThat(FolderScan.scan(folder).entries().get("stanford-bunny").name())
                .isEqualTo("Stanford Bunny");
        assertThat(FolderScan.scan(folder).entries().get("apfel-2").format()).isEqualTo("ply");
    }

    @Test
    void shouldPassOverWhatIsNoModel() throws IOException {
        create("README.md", "kip.mtl", "kip.png", ".hidden.ply", ".git/x.ply", "noextension", "kip.obj");
        assertThat(FolderScan.scan(folder).entries().keySet()).containsExactly("kip");
    }

    @Test
    void shouldLookIntoSubFolders() throws IOException {
        create("kip/kip.obj", "deep/er/horse.ply");
        assertThat(FolderScan.scan(folder).entries().keySet()).containsExactly("deep--er--horse", "kip--kip");
    }

    @Test
    void shouldPreferAnArchiveToItsModel() throws IOException {
        create("bunny.ply", "bunny.jsm", "sub/bunny.ply");
        assertThat(FolderScan.scan(folder).entries().keySet()).containsExactly("bunny", "sub--bunny");
    }

    @Test
    void shouldFindAFileUnderItsLongIdAndUnderIdsOfEarlierVersions() throws IOException {
        create("cube.obj", "cube.stl", "kip/kip.obj", "a/horse.ply", "b/horse.ply");
        FolderScan scan = FolderScan.scan(folder);
        String stl = scan.entries().keySet().stream()
                .filter(id -> id.startsWith("cube-stl-"))
                .findFirst()
                .orElseThrow();
        assertThat(scan.entries().keySet()).containsExactlyInAnyOrder("cube", stl, "kip--kip", "a--horse", "b--horse");
        assertThat(scan.find("cube").format()).isEqualTo("obj");
        assertThat(scan.find(stl).format()).isEqualTo("stl");
        assertThat(scan.find("cube-stl").format()).isEqualTo("stl");
        assertThat(scan.find("kip").id()).isEqualTo("kip--kip");
        assertThat(scan.find("b-horse-ply").id()).isEqualTo("b--horse");
        // It would mean two models.
        assertThat(scan.find("horse")).isNull();
    }

    @Test
    void shouldGiveModelsThatWereSentTheIdsTheyWereSentUnder() throws IOException {
        create("uploads/chair.jsm", "uploads/old/chair.jsm");
        assertThat(FolderScan.scan(folder).entries().keySet()).containsExactly("chair", "uploads--old--chair");
        create("chair.obj");
        FolderScan scan = FolderScan.scan(folder);
        assertThat(scan.find("chair").format()).isEqualTo("obj");
        assertThat(scan.find("uploads-chair-jsm").path()).isEqualTo(folder.resolve("uploads/chair.jsm"));
    }

    @Test
    void shouldServeASingleFile() throws IOException {
        create("one.ply", "two.ply");
        assertThat(FolderScan.scan(folder.resolve("one.ply")).entries().keySet())
                .containsExactly("one");
    }

    @Test
    void shouldServeASingleFileWithoutExtension() throws IOException {
        create("Horse");
        assertThat(FolderScan.scan(folder.resolve("Horse")).entries().keySet()).containsExactly("horse");
    }

    @Test
    void shouldTakeBothFormsOfGltf() throws IOException {
        create("a.gltf", "b.GLB", "b.bin");
        assertThat(FolderScan.scan(folder).entries().keySet()).containsExactly("a", "b");
    }

    private void create(String... names) throws IOException {
        for (String name : names) {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            Files.writeString(file, "");
        }
    }
}
