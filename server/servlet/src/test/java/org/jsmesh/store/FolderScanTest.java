package org.jsmesh.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderScanTest {
    @TempDir
    Path folder;

    @Test
    void shouldNameModelsByTheirFiles() throws IOException {
        create("Stanford Bunny.obj", "Äpfel_2.PLY", "duck.glb");
        assertThat(ids()).containsExactly("apfel-2", "duck", "stanford-bunny");
        assertThat(scan().get("stanford-bunny").name()).isEqualTo("Stanford Bunny");
        assertThat(scan().get("apfel-2").format()).isEqualTo("ply");
    }

    @Test
    void shouldPassOverWhatIsNoModel() throws IOException {
        create("README.md", "kip.mtl", "kip.png", ".hidden.ply", ".git/x.ply", "noextension", "kip.obj");
        assertThat(ids()).containsExactly("kip");
    }

    @Test
    void shouldLookIntoSubFolders() throws IOException {
        create("kip/kip.obj", "deep/er/horse.ply");
        assertThat(ids()).containsExactly("deep--er--horse", "kip--kip");
    }

    @Test
    void shouldPreferAnArchiveToItsModel() throws IOException {
        create("bunny.ply", "bunny.jsm", "sub/bunny.ply");
        assertThat(ids()).containsExactly("bunny", "sub--bunny");
    }

    @Test
    void shouldFindAFileUnderItsLongIdAndUnderIdsOfEarlierVersions() throws IOException {
        create("cube.obj", "cube.stl", "kip/kip.obj", "a/horse.ply", "b/horse.ply");
        FolderIndex scan = scan();
        String stl = ids().stream()
                .filter(id -> id.startsWith("cube-stl-"))
                .findFirst()
                .orElseThrow();
        assertThat(ids()).containsExactlyInAnyOrder("cube", stl, "kip--kip", "a--horse", "b--horse");
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
        assertThat(ids()).containsExactly("chair", "uploads--old--chair");
        create("chair.obj");
        FolderIndex scan = scan();
        assertThat(scan.find("chair").format()).isEqualTo("obj");
        assertThat(scan.find("uploads-chair-jsm").path()).isEqualTo(folder.resolve("uploads/chair.jsm"));
    }

    @Test
    void shouldServeASingleFile() throws IOException {
        create("one.ply", "two.ply");
        assertThat(ids(folder.resolve("one.ply"))).containsExactly("one");
    }

    @Test
    void shouldServeASingleFileWithoutExtension() throws IOException {
        create("Horse");
        assertThat(ids(folder.resolve("Horse"))).containsExactly("horse");
    }

    @Test
    void shouldTakeBothFormsOfGltf() throws IOException {
        create("a.gltf", "b.GLB", "b.bin");
        assertThat(ids()).containsExactly("a", "b");
    }

    @Test
    void shouldFollowAFolderThatIsALink() throws IOException {
        create("models/one.ply");
        Path link = Files.createSymbolicLink(folder.resolve("link"), folder.resolve("models"));
        assertThat(ids(link)).containsExactly("one");
    }

    @Test
    void shouldTakeLinksToFilesAndPassOverLinksToFolders() throws IOException {
        create("models/one.ply", ".far/two.ply");
        Files.createSymbolicLink(folder.resolve("models/circle"), folder);
        Files.createSymbolicLink(folder.resolve("models/three.ply"), folder.resolve(".far/two.ply"));
        Files.createSymbolicLink(folder.resolve("models/nothing.ply"), folder.resolve("nothing"));
        assertThat(ids()).containsExactly("models--one", "models--three");
    }

    private FolderIndex scan() throws IOException {
        return Folders.scan(folder);
    }

    private SortedSet<String> ids() throws IOException {
        return ids(folder);
    }

    private static SortedSet<String> ids(Path root) throws IOException {
        return Folders.ids(Folders.scan(root));
    }

    private void create(String... names) throws IOException {
        for (String name : names) {
            Path file = folder.resolve(name);
            Files.createDirectories(file.getParent());
            Files.writeString(file, "");
        }
    }
}
